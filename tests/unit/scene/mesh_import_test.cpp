#include "engine/scene/mesh_import.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/file.h"

using namespace trocar;

namespace {

std::string triangle_ply(const std::string& vertex_count, const std::string& face) {
  return "ply\nformat ascii 1.0\nelement vertex " + vertex_count +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
         "property list uchar uint vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n" +
         face;
}

}  // namespace

TEST_CASE("a triangle is read with a normal that points to where it is counter-clockwise") {
  const Result<scene::Mesh> mesh = scene::parse_mesh(triangle_ply("3", "3 0 1 2\n"));
  REQUIRE(mesh);
  CHECK(mesh->positions.size() == 3);
  REQUIRE(mesh->indices.size() == 3);
  CHECK((mesh->normals[0] - Eigen::Vector3f::UnitZ()).norm() < 1e-5F);
}

TEST_CASE("a quadrilateral becomes two triangles") {
  const Result<scene::Mesh> mesh = scene::parse_mesh(
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_index\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
  REQUIRE(mesh);
  CHECK(mesh->indices == std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3});
}

TEST_CASE("properties are found by name, in any order, and normals are made unit") {
  const Result<scene::Mesh> mesh = scene::parse_mesh(
      "ply\r\nformat ascii 1.0\r\ncomment made by hand\r\nelement vertex 3\r\nproperty float z\r\n"
      "property uchar red\r\nproperty float nx\r\nproperty float ny\r\nproperty float nz\r\nproperty float x\r\n"
      "property float y\r\nelement face 1\r\nproperty list uchar int vertex_indices\r\nend_header\r\n"
      "5 255 0 0 -2 0 0\r\n5 255 0 0 -2 1 0\r\n5 255 0 0 -2 0 1\r\n3 0 2 1\r\n");
  REQUIRE(mesh);
  CHECK(mesh->positions[1] == Eigen::Vector3f(1.0F, 0.0F, 5.0F));
  CHECK(mesh->normals[1] == Eigen::Vector3f(0.0F, 0.0F, -1.0F));
}

TEST_CASE("what is no mesh is an error and never a picture of something else") {
  const std::string good = triangle_ply("3", "3 0 1 2\n");
  CHECK(scene::parse_mesh("").error().code() == ErrorCode::kCorrupt);
  CHECK(scene::parse_mesh("a picture of a mesh").error().code() == ErrorCode::kCorrupt);
  CHECK(scene::parse_mesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").error().code() == ErrorCode::kCorrupt);
  CHECK(scene::parse_mesh(good + "3 0 1 2\n").error().code() == ErrorCode::kCorrupt);
  CHECK(scene::parse_mesh("ply\nformat binary_little_endian 1.0\n").error().code() == ErrorCode::kUnsupported);
  CHECK(scene::import_mesh("/nowhere/at/all.ply").error().code() == ErrorCode::kIo);
}

TEST_CASE("a mesh cut short anywhere is an error") {
  const std::string good = triangle_ply("3", "3 0 1 2");
  for (std::size_t size = 0; size < good.size(); ++size) CHECK_FALSE(scene::parse_mesh(good.substr(0, size)));
  CHECK(scene::parse_mesh(good));
}

TEST_CASE("a triangle of a vertex that is not there is an error") {
  CHECK_FALSE(scene::parse_mesh(triangle_ply("3", "3 0 1 3\n")));
  CHECK_FALSE(scene::parse_mesh(triangle_ply("3", "3 0 1 4294967295\n")));
  CHECK_FALSE(scene::parse_mesh(triangle_ply("3", "3 0 1 -1\n")));
  CHECK_FALSE(scene::parse_mesh(triangle_ply("3", "2 0 1\n")));
}

TEST_CASE("a header that promises more than the file holds is an error, and reserves nothing") {
  CHECK_FALSE(scene::parse_mesh(triangle_ply("4000000000", "3 0 1 2\n")));
  CHECK_FALSE(scene::parse_mesh(triangle_ply("99999999999999999999999", "3 0 1 2\n")));
  CHECK_FALSE(scene::parse_mesh(triangle_ply("-1", "3 0 1 2\n")));
}

TEST_CASE("a mesh with a coordinate that is not finite is an error") {
  for (const std::string wrong : {"nan", "inf", "1e400", "0x1", "one"}) {
    std::string text = triangle_ply("3", "3 0 1 2\n");
    text.replace(text.find("\n1 0 0\n") + 1, 1, wrong);
    CHECK_FALSE(scene::parse_mesh(text));
  }
}

TEST_CASE("every vertex and face of a long file arrives as it was written") {
  constexpr int kCount = 5000;
  std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(kCount) +
                     "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                     std::to_string(kCount - 2) + "\nproperty list uchar uint vertex_indices\nend_header\n";
  for (int i = 0; i < kCount; ++i) {
    text += std::to_string(i) + " " + std::to_string(i * i % 1009) + " " + (i % 2 == 0 ? "0.5" : "-1.25e-1") + "\n";
  }
  for (int i = 2; i < kCount; ++i) {
    text += "3 " + std::to_string(i - 2) + " " + std::to_string(i - 1) + " " + std::to_string(i) + "\n";
  }
  const Result<scene::Mesh> mesh = scene::parse_mesh(text);
  REQUIRE(mesh);
  REQUIRE(mesh->positions.size() == kCount);
  REQUIRE(mesh->indices.size() == 3 * (kCount - 2));
  for (int i = 0; i < kCount; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Eigen::Vector3f wanted(static_cast<float>(i), static_cast<float>(i * i % 1009), i % 2 == 0 ? 0.5F : -0.125F);
    REQUIRE(mesh->positions[k] == wanted);
    if (i >= 2) REQUIRE(mesh->indices[3 * k - 6] == k - 2);
    if (i >= 2) REQUIRE(mesh->indices[3 * k - 4] == k);
  }
}

TEST_CASE("what the importer would misread or be broken by is refused before it sees it") {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = triangle_ply("3", "3 0 1 2\n");
    return text.replace(text.find(from), from.size(), to);
  };
  REQUIRE(scene::parse_mesh(with("1 0 0\n", "1 0 0\r\n")));
  for (const std::string& wrong :
       {with("1 0 0\n", "1 0 0\r"), with("1 0 0\n", "1 0\n0\n"), with("1 0 0\n", "\n1 0 0\n"),
        with("1 0 0\n", "1 0 0 0\n"), with("1 0 0\n", "1 0 0" + std::string(5000, ' ') + "\n"),
        with("float x", "float y"), with("float x", "int x"), with("float x", "complex x"),
        with("property float y", "comment y\nproperty float y"), with("3 0 1 2", "3 0 1 2 0"),
        with("list uchar", "list float"), with("1 0 0\n", std::string("1 0 0\0\n", 7))}) {
    CHECK_FALSE(scene::parse_mesh(wrong));
  }
}

TEST_CASE("an error of a file names the file") {
  const std::string path = share_path("assets/meshes/SOURCES.md").string();
  const auto mesh = scene::import_mesh(path);
  REQUIRE_FALSE(mesh);
  CHECK(mesh.error().text().find(path) != std::string::npos);
}
