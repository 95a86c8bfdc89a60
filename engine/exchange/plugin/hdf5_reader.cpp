#include <fmt/format.h>

#include <set>

#include "engine/exchange/plugin/hdf5_file.h"
#include "engine/exchange/plugin/hdf5_handles.h"

namespace trocar::exchange::hdf5 {
namespace {

using Kind = TreeNode::Kind;

constexpr int kDeepest = 12;
constexpr std::size_t kMostObjects = 400'000;
constexpr std::size_t kMostAttributes = 1'000;                     // of one object
constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 30;       // of one array
constexpr std::uint64_t kMostBytesInAll = std::uint64_t{2} << 30;  // of one file
constexpr std::uint64_t kMostTexts = 1'000'000;
constexpr std::size_t kLongestText = std::size_t{64} << 20;  // and of all texts of an array together
constexpr std::uint64_t kLongestAttribute = 100'000;         // numbers or texts

struct Link {
  std::string name;
  H5L_type_t type;
};

herr_t collect_link(hid_t, const char* name, const H5L_info_t* info, void* into) noexcept try {
  auto& links = *static_cast<std::vector<Link>*>(into);
  if (links.size() >= kMostObjects) return 1;
  links.push_back({name, info->type});
  return 0;
} catch (...) {
  return -1;
}

herr_t collect_name(hid_t, const char* name, const H5A_info_t*, void* into) noexcept try {
  auto& names = *static_cast<std::vector<std::string>*>(into);
  if (names.size() >= kMostAttributes) return 1;
  names.emplace_back(name);
  return 0;
} catch (...) {
  return -1;
}

/// Nothing for what is no simple space or has more than 32 dimensions.
std::optional<std::vector<std::uint64_t>> shape_of(const Space& space) {
  if (!space) return std::nullopt;
  const H5S_class_t type = H5Sget_simple_extent_type(space.get());
  if (type == H5S_SCALAR) return std::vector<std::uint64_t>{};
  if (type != H5S_SIMPLE) return std::nullopt;
  const int rank = H5Sget_simple_extent_ndims(space.get());
  if (rank < 0 || rank > H5S_MAX_RANK) return std::nullopt;
  std::vector<hsize_t> lengths(static_cast<std::size_t>(rank));
  if (H5Sget_simple_extent_dims(space.get(), lengths.data(), nullptr) != rank) return std::nullopt;
  return std::vector<std::uint64_t>(lengths.begin(), lengths.end());
}

/// What numbers of a type are read as; `kUnread` for other types.
Kind kind_of(const Type& type) {
  const std::size_t size = H5Tget_size(type.get());
  switch (H5Tget_class(type.get())) {
    case H5T_FLOAT:
      return size <= 4 ? Kind::kFloat32 : size <= 8 ? Kind::kFloat64 : Kind::kUnread;
    case H5T_INTEGER:
      if (size == 1 && H5Tget_sign(type.get()) == H5T_SGN_NONE) return Kind::kUint8;
      return size <= 8 ? Kind::kInt64 : Kind::kUnread;
    case H5T_STRING:
      return Kind::kTexts;
    default:
      return Kind::kUnread;
  }
}

hid_t memory_type(Kind kind) {
  if (kind == Kind::kFloat32) return H5T_NATIVE_FLOAT;
  if (kind == Kind::kInt64) return H5T_NATIVE_INT64;
  return kind == Kind::kUint8 ? H5T_NATIVE_UINT8 : H5T_NATIVE_DOUBLE;
}

/// Calls `read(type, buffer)` for `count` texts; nothing if that fails or they are too long.
template <typename Read>
std::optional<std::vector<std::string>> read_texts(const Type& type, const Space& space, std::size_t count,
                                                   const Read& read) {
  std::vector<std::string> texts;
  if (H5Tis_variable_str(type.get()) > 0) {
    std::vector<char*> pointers(count, nullptr);
    const bool good = read(type.get(), pointers.data()) >= 0;
    std::size_t total = 0;
    for (const char* text : pointers) {
      total += text == nullptr ? 0 : std::char_traits<char>::length(text);
      texts.emplace_back(good && text != nullptr && total <= kLongestText ? text : "");
    }
    if (good) H5Dvlen_reclaim(type.get(), space.get(), H5P_DEFAULT, pointers.data());
    return good && total <= kLongestText ? std::optional(std::move(texts)) : std::nullopt;
  }
  const std::size_t size = H5Tget_size(type.get());
  if (size == 0 || size > kLongestText / std::max<std::size_t>(count, 1)) return std::nullopt;
  std::string buffer(size * count, '\0');
  if (read(type.get(), buffer.data()) < 0) return std::nullopt;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string_view text(buffer.data() + i * size, size);
    texts.emplace_back(text.substr(0, text.find('\0')));
  }
  return texts;
}

/// Nothing for an attribute of another type, or one that is too long.
std::optional<Attribute> read_attribute(hid_t object, const std::string& name) {
  const AttributeHandle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT));
  if (!attribute) return std::nullopt;
  const Type type(H5Aget_type(attribute.get()));
  const Space space(H5Aget_space(attribute.get()));
  const auto shape = shape_of(space);
  if (!type || !shape || shape->size() > 1) return std::nullopt;
  const bool single = shape->empty();
  const std::uint64_t count = single ? 1 : shape->front();
  if (count > kLongestAttribute) return std::nullopt;
  const Kind kind = kind_of(type);
  const auto read = [&](hid_t as, void* into) { return H5Aread(attribute.get(), as, into); };
  if (kind == Kind::kTexts) {
    auto texts = read_texts(type, space, static_cast<std::size_t>(count), read);
    if (!texts) return std::nullopt;
    return single ? Attribute(std::move(texts->front())) : Attribute(std::move(*texts));
  }
  if (kind == Kind::kUnread) return std::nullopt;
  if (single && (kind == Kind::kInt64 || kind == Kind::kUint8)) {
    std::int64_t value = 0;
    return read(H5T_NATIVE_INT64, &value) < 0 ? std::nullopt : std::optional<Attribute>(value);
  }
  std::vector<double> values(static_cast<std::size_t>(count));
  if (count > 0 && read(H5T_NATIVE_DOUBLE, values.data()) < 0) return std::nullopt;
  return single ? Attribute(values.front()) : Attribute(std::move(values));
}

void read_attributes(hid_t object, TreeNode& node) {
  std::vector<std::string> names;
  hsize_t next = 0;
  H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, &next, collect_name, &names);
  for (const std::string& name : names) {
    if (auto value = read_attribute(object, name)) node.attributes[name] = std::move(*value);
  }
}

class FileReader {
 public:
  explicit FileReader(const std::function<Status(const TreeNode&)>& take) : take_(take) {}

  Status object(hid_t parent, const std::string& name, const std::string& path, int depth) {
    const Object opened(H5Oopen(parent, name.c_str(), H5P_DEFAULT));
    H5O_info_t info;
    if (!opened || H5Oget_info2(opened.get(), &info, H5O_INFO_BASIC) < 0) {
      return path.empty() ? Status(fail(ErrorCode::kCorrupt, "the HDF5 file is damaged: its root cannot be read"))
                          : unread(path, "it is damaged");
    }
    if (!seen_.insert(info.addr).second) return unread(path, "it is another name of something else in the file");
    TreeNode node;
    node.path = path;
    read_attributes(opened.get(), node);
    if (info.type == H5O_TYPE_DATASET) {
      read_array(opened.get(), node);
      return give(node);
    }
    if (info.type != H5O_TYPE_GROUP) return unread(path, "it is no group and no array");
    TROCAR_RETURN_IF_ERROR(give(node));
    return group(opened.get(), path, depth);
  }

 private:
  Status group(hid_t opened, const std::string& path, int depth) {
    std::vector<Link> links;
    hsize_t next = 0;
    if (H5Literate(opened, H5_INDEX_NAME, H5_ITER_INC, &next, collect_link, &links) < 0) {
      return unread(path + "/…", "the group is damaged");
    }
    for (const Link& link : links) {
      const std::string inside = path.empty() ? link.name : path + "/" + link.name;
      if (link.type != H5L_TYPE_HARD) {
        TROCAR_RETURN_IF_ERROR(unread(inside, "it is a link, and links are not followed"));
      } else if (depth >= kDeepest) {
        TROCAR_RETURN_IF_ERROR(unread(inside, "it is too deep in the file"));
      } else {
        TROCAR_RETURN_IF_ERROR(object(opened, link.name, inside, depth + 1));
      }
    }
    return {};
  }

  Status give(const TreeNode& node) {
    if (++given_ > kMostObjects) return fail(ErrorCode::kUnsupported, "the HDF5 file holds too many objects");
    return take_(node);
  }

  Status unread(const std::string& path, std::string why) {
    TreeNode node;
    node.path = path;
    node.kind = Kind::kUnread;
    node.why = std::move(why);
    return give(node);
  }

  /// Sets all but the path and the attributes; what cannot be read says why.
  void read_array(hid_t opened, TreeNode& node) {
    node.kind = Kind::kUnread;
    const Type type(H5Dget_type(opened));
    const Space space(H5Dget_space(opened));
    const auto shape = shape_of(space);
    if (!type || !shape) {
      node.why = "it is damaged or holds nothing";
      return;
    }
    node.shape = *shape;
    const Kind kind = kind_of(type);
    node.why = objection(opened, kind, node);
    if (!node.why.empty()) return;
    const bool good = kind == Kind::kTexts ? texts(opened, type, space, node) : numbers(opened, kind, node);
    if (!good) node.why = "it is damaged";
  }

  /// Why an array is not even tried; empty if nothing speaks against it.
  std::string objection(hid_t opened, Kind kind, const TreeNode& node) {
    const Properties properties(H5Dget_create_plist(opened));
    const H5D_layout_t layout = properties ? H5Pget_layout(properties.get()) : H5D_LAYOUT_ERROR;
    if (layout == H5D_VIRTUAL) return "it is a virtual array, made of other files";
    if (layout != H5D_COMPACT && layout != H5D_CONTIGUOUS && layout != H5D_CHUNKED) return "it is damaged";
    if (H5Pget_external_count(properties.get()) != 0) return "its numbers are in another file";
    if (kind == Kind::kUnread) return "it holds neither numbers nor texts";
    if (node.shape.size() > 2 || (kind == Kind::kTexts && node.shape.size() > 1)) return "it has too many dimensions";
    const std::uint64_t each = kind == Kind::kTexts ? kMostBytes / kMostTexts : bytes_of(kind);
    if (node.count() > kMostBytes / each) return "it is too large";
    if (kind != Kind::kTexts) bytes_ += node.count() * each;
    if (bytes_ > kMostBytesInAll) return "the file is too large to read all of it";
    if (layout != H5D_CHUNKED) return "";
    std::vector<hsize_t> chunk(H5S_MAX_RANK);
    const int rank = H5Pget_chunk(properties.get(), H5S_MAX_RANK, chunk.data());
    std::uint64_t size = 1;
    for (int i = 0; i < rank; ++i) {
      const std::uint64_t length = chunk[static_cast<std::size_t>(i)];
      if (length == 0 || size > kMostBytes / length) return "its chunks are too large";
      size *= length;
    }
    return rank < 0 ? "it is damaged" : "";
  }

  static bool numbers(hid_t opened, Kind kind, TreeNode& node) {
    std::string data(static_cast<std::size_t>(node.count()) * bytes_of(kind), '\0');
    if (!data.empty() && H5Dread(opened, memory_type(kind), H5S_ALL, H5S_ALL, H5P_DEFAULT, data.data()) < 0) {
      return false;
    }
    node.kind = kind;
    node.data = std::move(data);
    return true;
  }

  static bool texts(hid_t opened, const Type& type, const Space& space, TreeNode& node) {
    const auto read = [&](hid_t as, void* into) { return H5Dread(opened, as, H5S_ALL, H5S_ALL, H5P_DEFAULT, into); };
    auto read_all = read_texts(type, space, static_cast<std::size_t>(node.count()), read);
    if (!read_all) return false;
    node.kind = Kind::kTexts;
    node.texts = std::move(*read_all);
    return true;
  }

  const std::function<Status(const TreeNode&)>& take_;
  std::set<haddr_t> seen_;
  std::size_t given_ = 0;
  std::uint64_t bytes_ = 0;
};

}  // namespace

void be_quiet() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  H5PLset_loading_state(0);
}

Status read_file(const std::string& path, const std::function<Status(const TreeNode&)>& take) {
  const Properties access(H5Pcreate(H5P_FILE_ACCESS));
  if (!access || H5Pset_fapl_sec2(access.get()) < 0) return fail(ErrorCode::kUnsupported, "HDF5 does not work here");
  const File file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()));
  if (!file) return fail(ErrorCode::kCorrupt, "the file is not HDF5, or damaged");
  return FileReader(take).object(file.get(), "/", "", 0);
}

}  // namespace trocar::exchange::hdf5
