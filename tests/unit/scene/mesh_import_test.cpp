#include "engine/scene/mesh_import.h"

#include <doctest/doctest.h>

#include <string>

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
  const Result<scene::Mesh> mesh = scene::parse_mesh(triangle_ply("3", "3 0 1 2\n"), "ply");
  REQUIRE(mesh);
  CHECK(mesh->positions.size() == 3);
  REQUIRE(mesh->indices.size() == 3);
  CHECK((mesh->normals[0] - Eigen::Vector3f::UnitZ()).norm() < 1e-5F);
}

TEST_CASE("a quadrilateral becomes two triangles") {
  const Result<scene::Mesh> mesh = scene::parse_mesh("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n", "obj");
  REQUIRE(mesh);
  CHECK(mesh->indices.size() == 6);
}

TEST_CASE("what is no mesh is an error and never a picture of something else") {
  const std::string good = triangle_ply("3", "3 0 1 2\n");
  CHECK(scene::parse_mesh("", "ply").error().code() == ErrorCode::kCorrupt);
  CHECK(scene::parse_mesh("a picture of a mesh", "ply").error().code() == ErrorCode::kCorrupt);
  CHECK(scene::parse_mesh("a picture of a mesh", "obj").error().code() == ErrorCode::kCorrupt);
  CHECK(scene::parse_mesh("a picture of a mesh", "stl").error().code() == ErrorCode::kCorrupt);
  CHECK(scene::parse_mesh(good.substr(0, good.size() / 2), "ply").error().code() == ErrorCode::kCorrupt);
  CHECK(scene::parse_mesh(good.substr(0, good.find("end_header")), "ply").error().code() == ErrorCode::kCorrupt);
  CHECK(scene::parse_mesh(good, "fbx").error().code() == ErrorCode::kUnsupported);
  CHECK(scene::import_mesh("/nowhere/at/all.ply").error().code() == ErrorCode::kNotFound);
}

TEST_CASE("a triangle of a vertex that is not there is an error") {
  CHECK_FALSE(scene::parse_mesh(triangle_ply("3", "3 0 1 3\n"), "ply"));
  CHECK_FALSE(scene::parse_mesh(triangle_ply("3", "3 0 1 4294967295\n"), "ply"));
  CHECK_FALSE(scene::parse_mesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999999\n", "obj"));
}

TEST_CASE("a header that promises more than the file holds is an error, and reserves nothing") {
  CHECK_FALSE(scene::parse_mesh(triangle_ply("4000000000", "3 0 1 2\n"), "ply"));
  CHECK_FALSE(scene::parse_mesh(triangle_ply("99999999999999999999999", "3 0 1 2\n"), "ply"));
  CHECK_FALSE(scene::parse_mesh(triangle_ply("-1", "3 0 1 2\n"), "ply"));
}

TEST_CASE("a mesh with a coordinate that is not finite is an error") {
  CHECK_FALSE(scene::parse_mesh("v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "obj"));
  CHECK_FALSE(scene::parse_mesh("v inf 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "obj"));
}

TEST_CASE("an error of a file names the file") {
  const std::string path = share_path("assets/meshes/SOURCES.md").string();
  const auto mesh = scene::import_mesh(path);
  REQUIRE_FALSE(mesh);
  CHECK(mesh.error().text().find(path) != std::string::npos);
}
