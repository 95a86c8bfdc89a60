#include "engine/render/renderer.h"

#include <doctest/doctest.h>

#include <array>
#include <memory>
#include <vector>

#include "engine/core/random.h"
#include "engine/scene/primitives.h"

using namespace trocar;
using Eigen::Vector3d;
using Eigen::Vector3f;
using Eigen::Vector4f;

namespace {

/// One renderer for the whole program: contexts are costly and its thread is the tests' only one.
render::Renderer& renderer() {
  static Result<render::Renderer> made = render::Renderer::create();
  REQUIRE(made);
  return *made;
}

std::shared_ptr<const scene::Mesh> cube() {
  static const auto kCube = std::make_shared<const scene::Mesh>(scene::unit_cube());
  return kCube;
}

scene::Node box(const Vector3d& centre, const Vector3f& size, const Vector4f& colour, float emission) {
  scene::Node node;
  node.mesh = cube();
  node.material.base_colour = colour;
  node.material.emission = emission;
  node.X_WM = scene::node_pose(spatial::Pose::translation(centre), size);
  return node;
}

const scene::Camera& from_above() {
  static const scene::Camera kCamera = scene::Camera::look_at({0.0, 0.0, 0.2}, {0.0, 0.0, 0.0});
  return kCamera;
}

render::RenderOptions small(int samples = 1) {
  return {160, 90, samples, true, true};
}

Image draw(const scene::Scene& scene, const render::RenderOptions& options = small()) {
  Result<Image> image = renderer().draw(scene, from_above(), options);
  REQUIRE(image);
  return std::move(*image);
}

const Vector4f kRed(1.0F, 0.0F, 0.0F, 1.0F);
const Vector4f kGreen(0.0F, 1.0F, 0.0F, 1.0F);

}  // namespace

TEST_CASE("an empty scene is its background from top to bottom") {
  const scene::Scene scene;
  const Image image = draw(scene);
  CHECK(image.width == 160);
  CHECK(image.height == 90);
  CHECK(std::abs(image.at(80, 0).r - scene.background_top.r) <= 1);
  CHECK(std::abs(image.at(80, 89).b - scene.background_bottom.b) <= 1);
  CHECK(image.at(80, 0).r > image.at(80, 89).r);
  CHECK(image.at(5, 5).a == 255);
}

TEST_CASE("an unlit thing has exactly its colour, so that a colour bar tells the truth") {
  scene::Scene scene;
  const Rgba wanted{68, 1, 84, 255};
  scene.nodes.push_back(
      box({0, 0, 0}, {0.05F, 0.05F, 0.01F}, {68.0F / 255.0F, 1.0F / 255.0F, 84.0F / 255.0F, 1.0F}, 1.0F));
  const Rgba seen = draw(scene).at(80, 45);
  CHECK(std::abs(seen.r - wanted.r) <= 1);
  CHECK(std::abs(seen.g - wanted.g) <= 1);
  CHECK(std::abs(seen.b - wanted.b) <= 1);
}

TEST_CASE("what is at +y is drawn to the right and what is farther away higher, seen from above") {
  scene::Scene scene;
  scene.nodes.push_back(box({0, 0.04, 0}, {0.01F, 0.01F, 0.01F}, kRed, 1.0F));
  scene.nodes.push_back(box({-0.04, 0, 0}, {0.01F, 0.01F, 0.01F}, kGreen, 1.0F));
  const Image image = draw(scene);
  const Vector3d right = from_above().project({0, 0.04, 0}, 160, 90);
  const Vector3d high = from_above().project({-0.04, 0, 0}, 160, 90);
  CHECK(right.x() > 100.0);
  CHECK(high.y() < 30.0);
  CHECK(image.at(static_cast<int>(right.x()), static_cast<int>(right.y())) == Rgba{255, 0, 0, 255});
  CHECK(image.at(static_cast<int>(high.x()), static_cast<int>(high.y())) == Rgba{0, 255, 0, 255});
}

TEST_CASE("the nearer of two things hides the other, whichever comes first") {
  for (const bool red_first : {true, false}) {
    scene::Scene scene;
    const scene::Node near_red = box({0, 0, 0.05}, {0.03F, 0.03F, 0.01F}, kRed, 1.0F);
    const scene::Node far_green = box({0, 0, 0}, {0.06F, 0.06F, 0.01F}, kGreen, 1.0F);
    scene.nodes = red_first ? std::vector{near_red, far_green} : std::vector{far_green, near_red};
    CHECK(draw(scene).at(80, 45) == Rgba{255, 0, 0, 255});
  }
}

TEST_CASE("see-through things are mixed from far to near, whichever comes first") {
  Image first;
  for (const bool red_first : {true, false}) {
    scene::Scene scene;
    const scene::Node red = box({0, 0, 0.05}, {0.06F, 0.06F, 0.001F}, {1.0F, 0.0F, 0.0F, 0.5F}, 1.0F);
    const scene::Node green = box({0, 0, 0}, {0.09F, 0.09F, 0.001F}, {0.0F, 1.0F, 0.0F, 0.5F}, 1.0F);
    scene.nodes = red_first ? std::vector{red, green} : std::vector{green, red};
    const Image image = draw(scene);
    CHECK(image.at(80, 45).r > image.at(80, 45).g + 40);
    if (red_first) first = image;
    if (!red_first) CHECK(image == first);
  }
}

TEST_CASE("a box darkens the floor on the side away from the light, and not without shadows") {
  scene::Scene scene;
  scene.light_direction = {0.0F, -1.0F, -1.0F};
  scene.nodes.push_back(box({0, 0, -0.005}, {0.1F, 0.1F, 0.01F}, {0.8F, 0.8F, 0.8F, 1.0F}, 0.0F));
  scene.nodes.push_back(box({0, 0, 0.01}, {0.02F, 0.02F, 0.02F}, {0.8F, 0.8F, 0.8F, 1.0F}, 0.0F));
  const auto brightness = [](const Image& image, double y_m) {
    const Vector3d pixel = from_above().project({0.0, y_m, 0.0}, 160, 90);
    return static_cast<int>(image.at(static_cast<int>(pixel.x()), static_cast<int>(pixel.y())).g);
  };
  for (const bool soft : {false, true}) {
    render::RenderOptions options = small();
    options.soft_shadows = soft;
    const Image image = draw(scene, options);
    CHECK(brightness(image, -0.020) < brightness(image, 0.020) - 40);
  }
  render::RenderOptions bare = small();
  bare.shadows = false;
  const Image image = draw(scene, bare);
  CHECK(std::abs(brightness(image, -0.020) - brightness(image, 0.020)) < 25);
}

TEST_CASE("a lit floor is even: it does not shadow itself") {
  scene::Scene scene;
  scene.nodes.push_back(box({0, 0, -0.005}, {0.12F, 0.12F, 0.01F}, {0.5F, 0.5F, 0.5F, 1.0F}, 0.0F));
  scene.nodes.back().material.roughness = 1.0F;
  const Image image = draw(scene);
  for (int x = 65; x < 95; ++x) {
    for (int y = 30; y < 60; ++y) CHECK(std::abs(image.at(x, y).g - image.at(80, 45).g) <= 6);
  }
}

TEST_CASE("row 0 of a quad's picture is at origin plus v and its column 0 at the origin") {
  auto texture = std::make_shared<Image>(2, 2);
  texture->set(0, 0, {255, 0, 0, 255});
  texture->set(1, 0, {0, 255, 0, 255});
  texture->set(0, 1, {0, 0, 255, 255});
  texture->set(1, 1, {255, 255, 255, 255});
  scene::Scene scene;
  // u is to the right and v upwards in the picture.
  scene.quads.push_back({{0.03F, -0.03F, 0.0F}, {0.0F, 0.06F, 0.0F}, {-0.06F, 0.0F, 0.0F}, texture, 1.0F});
  const Image image = draw(scene);
  CHECK(image.at(80 - 10, 45 - 10) == Rgba{255, 0, 0, 255});
  CHECK(image.at(80 + 10, 45 - 10) == Rgba{0, 255, 0, 255});
  CHECK(image.at(80 - 10, 45 + 10) == Rgba{0, 0, 255, 255});
  CHECK(image.at(80 + 10, 45 + 10) == Rgba{255, 255, 255, 255});
}

TEST_CASE("texels without opacity let the background through") {
  auto texture = std::make_shared<Image>(2, 2, Rgba{255, 255, 255, 0});
  scene::Scene scene;
  const Image empty = draw(scene);
  scene.quads.push_back({{0.03F, -0.03F, 0.0F}, {0.0F, 0.06F, 0.0F}, {-0.06F, 0.0F, 0.0F}, texture, 1.0F});
  CHECK(draw(scene) == empty);
}

TEST_CASE("the same scene gives the same bytes, whatever was drawn in between") {
  scene::Scene scene;
  scene.nodes.push_back(box({0, 0, 0}, {0.05F, 0.03F, 0.02F}, {0.7F, 0.3F, 0.2F, 1.0F}, 0.0F));
  for (const int samples : {1, 2, 4}) {
    const Image first = draw(scene, small(samples));
    static_cast<void>(draw(scene::Scene{}, {64, 64, 1, false, false}));
    CHECK(draw(scene, small(samples)) == first);
  }
}

TEST_CASE("several samples a pixel smooth an edge that one sample leaves hard") {
  scene::Scene scene;
  scene.background_top = scene.background_bottom = {0, 0, 0, 255};
  scene::Node node = box({0, 0, 0}, {0.05F, 0.05F, 0.001F}, {1.0F, 1.0F, 1.0F, 1.0F}, 1.0F);
  const spatial::Pose turned{{0, 0, 0}, Eigen::Quaterniond(Eigen::AngleAxisd(0.3, Vector3d::UnitZ()))};
  node.X_WM = scene::node_pose(turned, {0.05F, 0.05F, 0.001F});
  scene.nodes.push_back(node);
  const auto greys = [](const Image& image) {
    int count = 0;
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        if (const int v = image.at(x, y).r; v > 30 && v < 225) ++count;
      }
    }
    return count;
  };
  CHECK(greys(draw(scene, small(1))) == 0);
  CHECK(greys(draw(scene, small(4))) > 50);
}

TEST_CASE("a size or a number of samples that no picture has is an error") {
  const scene::Scene scene;
  for (const render::RenderOptions& wrong :
       {render::RenderOptions{0, 90}, {160, -1}, {8193, 90}, {160, 8193}, {160, 90, 3}, {160, 90, 0}}) {
    const Result<Image> image = renderer().draw(scene, from_above(), wrong);
    REQUIRE_FALSE(image);
    CHECK(image.error().code() == ErrorCode::kInvalidArgument);
  }
}

TEST_CASE("a scene's picture does not depend on the address of its meshes") {
  Image first;
  for (int i = 0; i < 4; ++i) {
    scene::Scene scene;
    scene.nodes.push_back(box({0, 0, 0}, {0.05F, 0.03F, 0.02F}, kRed, 0.5F));
    scene.nodes.back().mesh = std::make_shared<const scene::Mesh>(scene::unit_cube());
    const Image image = draw(scene);
    if (i == 0) first = image;
    CHECK(image == first);
  }
}

TEST_CASE("the description names the software renderer and its OpenGL") {
  CHECK(renderer().description().find("OpenGL") != std::string::npos);
}

namespace {

/// Everything is drawn anew after this: another eye, another light.
void forget(const render::RenderOptions& options) {
  scene::Scene other;
  other.light_direction = {0.4F, 0.0F, -1.0F};
  const scene::Camera camera = scene::Camera::look_at({0.1, 0.1, 0.1}, {0.0, 0.0, 0.0});
  REQUIRE(renderer().draw(other, camera, options));
}

/// A floor, things that stand on it, and some of each kind that wander: opaque, see-through, a slice, a thing that
/// comes and goes.
scene::Scene wandering(Random& random, int step) {
  static const auto kTexture = std::make_shared<const Image>(8, 8, Rgba{40, 200, 90, 120});
  scene::Scene scene;
  const auto somewhere = [&random](double half, double low, double high) {
    return Vector3d(random.uniform(-half, half), random.uniform(-half, half), random.uniform(low, high));
  };
  scene.nodes.push_back(box({0, 0, -0.005}, {0.10F, 0.12F, 0.01F}, {0.6F, 0.6F, 0.6F, 1.0F}, 0.0F));
  for (int i = 0; i < 4; ++i) {
    scene.nodes.push_back(box({0.02 * i - 0.03, 0.015, 0.01}, {0.004F, 0.006F, 0.02F}, {0.2F, 0.5F, 0.9F, 1.0F}, 0.0F));
    scene.nodes.back().material.metallic = i % 2 == 0 ? 1.0F : 0.0F;
  }
  if (step % 3 == 1) scene.nodes.push_back(box({0, -0.03, 0.003}, {0.02F, 0.02F, 0.006F}, kRed, 0.5F));
  scene.nodes.push_back(box(somewhere(0.05, 0.01, 0.06), {0.01F, 0.02F, 0.008F}, {0.9F, 0.7F, 0.1F, 1.0F}, 0.0F));
  scene.nodes.push_back(box(somewhere(0.03, 0.01, 0.03), {0.015F, 0.01F, 0.008F}, {0.9F, 0.2F, 0.8F, 0.5F}, 0.2F));
  scene.nodes.push_back(box({0.02, -0.02, 0.02}, {0.015F, 0.01F, 0.008F}, {0.2F, 0.9F, 0.8F, 0.5F}, 0.2F));
  const float x = step % 4 == 0 ? -0.02F : 0.01F;
  scene.quads.push_back({{x, -0.03F, 0.002F}, {0.0F, 0.03F, 0.0F}, {0.0F, 0.0F, 0.02F}, kTexture, 0.8F});
  return scene;
}

}  // namespace

TEST_CASE("a picture drawn only where it changed is to the byte the one drawn anew") {
  Random random(7);
  const std::array cameras{scene::Camera::look_at({0.15, 0.02, 0.12}, {0.0, 0.0, 0.0}),
                           scene::Camera::look_at({0.03, 0.0, 0.02}, {0.0, 0.0, 0.01})};
  for (const scene::Camera& camera : cameras) {
    for (const render::RenderOptions options :
         {render::RenderOptions{320, 200, 1, true, false}, render::RenderOptions{320, 200, 4, true, true},
          render::RenderOptions{320, 200, 1, false, false}}) {
      forget(options);
      for (int step = 0; step < 12; ++step) {
        const scene::Scene scene = wandering(random, step);
        const Result<Image> changed = renderer().draw(scene, camera, options);
        REQUIRE(changed);
        if (step % 2 == 0) continue;  // So that changes on top of changes are met too.
        forget(options);
        const Result<Image> anew = renderer().draw(scene, camera, options);
        REQUIRE(anew);
        CHECK(*changed == *anew);
      }
    }
  }
}

TEST_CASE("a thing that moves takes its shadow along, from wherever the last picture left it") {
  scene::Scene scene;
  scene.light_direction = {0.0F, -1.0F, -1.0F};
  scene.nodes.push_back(box({0, 0, -0.005}, {0.1F, 0.1F, 0.01F}, {0.8F, 0.8F, 0.8F, 1.0F}, 0.0F));
  const Image empty = draw(scene);
  scene.nodes.push_back(box({0, 0.01, 0.03}, {0.01F, 0.01F, 0.01F}, {0.8F, 0.8F, 0.8F, 1.0F}, 0.0F));
  const auto at = [](const Image& image, double y_m) {
    const Vector3d pixel = from_above().project({0.0, y_m, 0.0}, 160, 90);
    return image.at(static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
  };
  CHECK(at(draw(scene), -0.020).g < at(empty, -0.020).g - 40);
  scene.nodes.back().X_WM(1, 3) += 0.02F;
  const Image moved = draw(scene);
  CHECK(at(moved, -0.020) == at(empty, -0.020));
  CHECK(at(moved, 0.0).g < at(empty, 0.0).g - 40);
  scene.nodes.pop_back();
  CHECK(draw(scene) == empty);
}
