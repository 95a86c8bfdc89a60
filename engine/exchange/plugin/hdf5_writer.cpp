#include <fmt/format.h>

#include <algorithm>

#include "engine/exchange/plugin/hdf5_file.h"
#include "engine/exchange/plugin/hdf5_handles.h"

namespace trocar::exchange::hdf5 {
namespace {

using Kind = TreeNode::Kind;

/// Bytes of a chunk; smaller arrays are neither cut nor compressed.
constexpr std::uint64_t kChunk = 128 * 1024;

tl::unexpected<Error> could_not(std::string_view what) {
  return fail(ErrorCode::kIo, fmt::format("could not write the file ({} does not go into it)", what));
}

/// UTF-8 of `size` bytes, or of any length.
Type text_type(std::size_t size) {
  Type type(H5Tcopy(H5T_C_S1));
  H5Tset_size(type.get(), size);
  H5Tset_cset(type.get(), H5T_CSET_UTF8);
  H5Tset_strpad(type.get(), size == H5T_VARIABLE ? H5T_STR_NULLTERM : H5T_STR_NULLPAD);
  return type;
}

hid_t number_type(Kind kind) {
  if (kind == Kind::kFloat32) return H5T_IEEE_F32LE;
  if (kind == Kind::kInt64) return H5T_STD_I64LE;
  return kind == Kind::kUint8 ? H5T_STD_U8LE : H5T_IEEE_F64LE;
}

Space space_of(const std::vector<std::uint64_t>& shape) {
  if (shape.empty()) return Space(H5Screate(H5S_SCALAR));
  const std::vector<hsize_t> lengths(shape.begin(), shape.end());
  return Space(H5Screate_simple(static_cast<int>(lengths.size()), lengths.data(), nullptr));
}

bool write_attribute(hid_t object, const std::string& name, hid_t type, const Space& space, const void* value) {
  const AttributeHandle attribute(H5Acreate2(object, name.c_str(), type, space.get(), H5P_DEFAULT, H5P_DEFAULT));
  return attribute && H5Awrite(attribute.get(), type, value) >= 0;
}

bool write_texts(hid_t object, const std::string& name, const Space& space, const std::vector<std::string>& texts) {
  std::vector<const char*> pointers;
  for (const std::string& text : texts) pointers.push_back(text.c_str());
  const Type type = text_type(H5T_VARIABLE);
  return write_attribute(object, name, type.get(), space, pointers.data());
}

bool write_value(hid_t object, const std::string& name, const Attribute& value) {
  if (const auto* real = std::get_if<double>(&value)) {
    return write_attribute(object, name, H5T_NATIVE_DOUBLE, space_of({}), real);
  }
  if (const auto* whole = std::get_if<std::int64_t>(&value)) {
    return write_attribute(object, name, H5T_NATIVE_INT64, space_of({}), whole);
  }
  if (const auto* text = std::get_if<std::string>(&value)) return write_texts(object, name, space_of({}), {*text});
  if (const auto* reals = std::get_if<std::vector<double>>(&value)) {
    return write_attribute(object, name, H5T_NATIVE_DOUBLE, space_of({reals->size()}), reals->data());
  }
  const auto& texts = std::get<std::vector<std::string>>(value);
  return write_texts(object, name, space_of({texts.size()}), texts);
}

/// Large arrays in compressed chunks of whole rows; no time of writing, so that the same gives the same bytes.
Properties layout_of(const TreeNode& node, std::size_t each) {
  Properties properties(H5Pcreate(H5P_DATASET_CREATE));
  H5Pset_obj_track_times(properties.get(), false);
  if (node.shape.empty() || node.count() * each <= kChunk) return properties;
  const std::uint64_t row = node.count() / node.shape.front() * each;
  std::vector<hsize_t> chunk(node.shape.begin(), node.shape.end());
  chunk[0] = std::clamp<std::uint64_t>(kChunk / row, 1, node.shape.front());
  H5Pset_chunk(properties.get(), static_cast<int>(chunk.size()), chunk.data());
  H5Pset_shuffle(properties.get());
  H5Pset_deflate(properties.get(), 1);
  return properties;
}

}  // namespace

struct FileWriter::Impl {
  File file;

  Status group(const TreeNode& node) {
    const Properties properties(H5Pcreate(H5P_GROUP_CREATE));
    H5Pset_obj_track_times(properties.get(), false);
    // The root is there already; it may get attributes.
    const Object made(node.path.empty()
                          ? H5Gopen2(file.get(), "/", H5P_DEFAULT)
                          : H5Gcreate2(file.get(), node.path.c_str(), H5P_DEFAULT, properties.get(), H5P_DEFAULT));
    return made ? attributes(made.get(), node) : could_not(node.path);
  }

  Status array(const TreeNode& node, hid_t type, std::size_t each, const void* data) {
    const Space space = space_of(node.shape);
    const Properties layout = layout_of(node, each);
    const Array made(
        H5Dcreate2(file.get(), node.path.c_str(), type, space.get(), H5P_DEFAULT, layout.get(), H5P_DEFAULT));
    if (!made) return could_not(node.path);
    if (node.count() > 0 && H5Dwrite(made.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) < 0) {
      return could_not(node.path);
    }
    return attributes(made.get(), node);
  }

  static Status attributes(hid_t object, const TreeNode& node) {
    for (const auto& [name, value] : node.attributes) {
      if (!write_value(object, name, value)) return could_not(node.path + "@" + name);
    }
    return {};
  }

  Status texts(const TreeNode& node) {
    std::size_t size = 1;
    for (const std::string& text : node.texts) size = std::max(size, text.size());
    std::string padded;
    for (const std::string& text : node.texts) padded += text + std::string(size - text.size(), '\0');
    const Type type = text_type(size);
    return array(node, type.get(), size, padded.data());
  }
};

FileWriter::FileWriter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
FileWriter::FileWriter(FileWriter&&) noexcept = default;
FileWriter& FileWriter::operator=(FileWriter&&) noexcept = default;
FileWriter::~FileWriter() = default;

Result<FileWriter> FileWriter::create(const std::string& path) {
  auto impl = std::make_unique<Impl>();
  const Properties creation(H5Pcreate(H5P_FILE_CREATE));
  H5Pset_obj_track_times(creation.get(), false);
  impl->file = File(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.get(), H5P_DEFAULT));
  if (!impl->file) return fail(ErrorCode::kIo, "could not create the file");
  return FileWriter(std::move(impl));
}

Status FileWriter::add(const TreeNode& node) {
  if (node.kind == Kind::kGroup) return impl_->group(node);
  if (node.kind == Kind::kTexts) return impl_->texts(node);
  if (!node.holds_numbers()) return could_not(node.path);
  return impl_->array(node, number_type(node.kind), bytes_of(node.kind), node.data.data());
}

Status FileWriter::close() {
  const bool flushed = H5Fflush(impl_->file.get(), H5F_SCOPE_LOCAL) >= 0;
  const bool closed = impl_->file.reset();
  if (flushed && closed) return {};
  return fail(ErrorCode::kIo, "could not write all of the file (is the disk full?)");
}

}  // namespace trocar::exchange::hdf5
