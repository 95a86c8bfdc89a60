#include "engine/render/renderer.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "engine/render/damage.h"
#include "engine/render/draw_list.h"
#include "engine/render/frame_target.h"
#include "engine/render/items.h"
#include "engine/render/mesh_cache.h"
#include "engine/render/osmesa_context.h"
#include "engine/render/programs.h"
#include "engine/render/shadow_sweep.h"

namespace trocar::render {
namespace {

constexpr int kSizeLimit = 8192;

ShadowKind shadow_kind(const RenderOptions& options) {
  if (!options.shadows) return ShadowKind::kNone;
  return options.soft_shadows ? ShadowKind::kSoft : ShadowKind::kHard;
}

/// A picture that stays where it was drawn, to be changed where the next one differs.
struct Kept {
  explicit Kept(const GlFunctions& gl) : target(gl) {}

  FrameTarget target;
  std::vector<Item> items;
  std::optional<View> view;  ///< None while what is on the target is not known.
  ShadowKind kind = ShadowKind::kNone;
  std::uint64_t used = 0;
};

/// The coarse picture and the fine one.
constexpr std::size_t kKept = 2;
/// How far from where it falls a shadow darkens, in texels of the map: four taps, smoothed, looked up beside the
/// surface.
constexpr float kShadowReach_texels = 5.0F;

/// What can differ between the picture of `before` and that of `now` from the same view.
std::vector<PixelBox> damage(const std::vector<Item>& before, const std::vector<Item>& now, const scene::Scene& scene,
                             MeshCache& cache, const View& view, ShadowKind kind) {
  const Changes found = changes(before, now);
  if (found.none()) return {};
  Damage damage({view.clip_from_world, view.width, view.height});
  const ShadowSweep sweep(scene, now, found, cache, -view.to_light, kShadowReach_texels * view.shadow_texel_m);
  for (const std::vector<const Item*>* side : {&found.gone, &found.come}) {
    for (const Item* item : *side) {
      damage.add(item->corners);
      if (kind != ShadowKind::kNone && item->casts_shadow) sweep.add(item->corners, damage);
    }
  }
  return damage.boxes();
}

/// Marks the items that can be seen in a part of the window.
template <typename Use>
std::vector<std::uint8_t> within(const std::vector<Item>& items, const Window& window, const PixelBox& box, Use use) {
  std::vector<std::uint8_t> marks(items.size(), 0);
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (items[i].source == 0 || !use(items[i])) continue;
    const std::optional<PixelBox> seen = bounds(items[i].corners, window);
    marks[i] = !seen || seen->meets(box) ? 1 : 0;
  }
  return marks;
}

}  // namespace

struct Renderer::Impl {
  explicit Impl(OsmesaContext made) : context(std::move(made)), gl(context.gl()), cache(gl), shadow_map(gl) {
    gl.GenBuffers(1, &instance_buffer);
    gl.GenVertexArrays(1, &empty_array);
  }
  ~Impl() {
    programs.release(gl);
    gl.DeleteBuffers(1, &instance_buffer);
    gl.DeleteVertexArrays(1, &empty_array);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  /// Fills `depth` unless it is null.
  Result<Image> picture(const scene::Scene& scene, const scene::Camera& camera, const RenderOptions& options,
                        std::vector<float>* depth);
  Kept& kept_for(const RenderOptions& options);
  void upload_instances(const DrawList& list) const;
  void draw_batch(const Batch& batch, std::size_t count) const;
  void update_shadows(const scene::Scene& scene, const scene::Camera& camera, const std::vector<Item>& items,
                      const View& view);
  void draw_shadows(const DrawList& list, const View& view, const PixelBox& box, bool whole) const;
  void draw_background(const View& view) const;
  void draw_opaque(const DrawList& list, const View& view, ShadowKind kind, bool whole) const;
  void draw_blended(const DrawList& list, const View& view, const scene::Scene& scene, ShadowKind kind);

  OsmesaContext context;  // First in, last out: everything below lives in it.
  const GlFunctions& gl;
  MeshCache cache;
  std::vector<std::unique_ptr<Kept>> kept;
  std::uint64_t pictures = 0;
  ShadowMap shadow_map;
  std::vector<Item> shadow_items;
  std::optional<Eigen::Matrix4f> shadow_clip;  ///< None while what is on the map is not known.
  Programs programs;
  GLuint instance_buffer = 0;
  GLuint empty_array = 0;
};

Kept& Renderer::Impl::kept_for(const RenderOptions& options) {
  ++pictures;
  for (const auto& one : kept) {
    if (!one->target.is(options.width, options.height, options.samples)) continue;
    one->used = pictures;
    return *one;
  }
  if (kept.size() == kKept) {
    kept.erase(
        std::min_element(kept.begin(), kept.end(), [](const auto& a, const auto& b) { return a->used < b->used; }));
  }
  kept.push_back(std::make_unique<Kept>(gl));
  kept.back()->used = pictures;
  return *kept.back();
}

void Renderer::Impl::upload_instances(const DrawList& list) const {
  gl.BindBuffer(GL_ARRAY_BUFFER, instance_buffer);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(list.instances.size() * sizeof(Instance)),
                list.instances.data(), GL_STREAM_DRAW);
}

void Renderer::Impl::draw_batch(const Batch& batch, std::size_t count) const {
  if (count == 0) return;
  gl.BindVertexArray(batch.mesh->vertex_array);
  gl.BindBuffer(GL_ARRAY_BUFFER, instance_buffer);
  cache.point_at_instances(batch.first);
  gl.DrawElementsInstanced(GL_TRIANGLES, batch.mesh->index_count, GL_UNSIGNED_INT, nullptr,
                           static_cast<GLsizei>(count));
}

void Renderer::Impl::update_shadows(const scene::Scene& scene, const scene::Camera& camera,
                                    const std::vector<Item>& items, const View& view) {
  const Window window{view.shadow_clip_from_world, ShadowMap::kSize, ShadowMap::kSize};
  Damage damage(window);
  const bool whole = !shadow_clip || *shadow_clip != view.shadow_clip_from_world;
  if (whole) damage.add_all();
  const Changes found = changes(shadow_items, items);
  for (const std::vector<const Item*>* side : {&found.gone, &found.come}) {
    for (const Item* item : *side) {
      if (!whole && item->casts_shadow) damage.add(item->corners);
    }
  }
  shadow_clip.reset();
  for (const PixelBox& box : damage.boxes()) {
    const DrawList list = make_draw_list(
        scene, camera, cache, within(items, window, box, [](const Item& item) { return item.casts_shadow; }));
    upload_instances(list);
    draw_shadows(list, view, box, whole);
  }
  shadow_items = items;
  shadow_clip = view.shadow_clip_from_world;
}

void Renderer::Impl::draw_shadows(const DrawList& list, const View& view, const PixelBox& box, bool whole) const {
  shadow_map.bind_for_drawing();
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LEQUAL);
  gl.DepthMask(GL_TRUE);
  gl.Enable(GL_CULL_FACE);
  gl.CullFace(GL_BACK);
  gl.FrontFace(GL_CW);
  if (whole) gl.Clear(GL_DEPTH_BUFFER_BIT);
  // The outermost texels stay as cleared: they stand for all that is beyond.
  const int left = std::max(box.left, 1);
  const int low = std::max(box.top, 1);
  const int right = std::min(box.right, ShadowMap::kSize - 1);
  const int high = std::min(box.bottom, ShadowMap::kSize - 1);
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(left, low, std::max(0, right - left), std::max(0, high - low));
  if (!whole) gl.Clear(GL_DEPTH_BUFFER_BIT);
  gl.Enable(GL_POLYGON_OFFSET_FILL);
  gl.PolygonOffset(1.5F, 4.0F);
  programs.use_shadow(gl, view);
  for (const Batch& batch : list.opaque) draw_batch(batch, batch.caster_count);
  gl.Disable(GL_POLYGON_OFFSET_FILL);
  gl.Disable(GL_SCISSOR_TEST);
}

void Renderer::Impl::draw_background(const View& view) const {
  programs.use_background(gl, view);
  gl.Disable(GL_CULL_FACE);
  gl.BindVertexArray(empty_array);
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

void Renderer::Impl::draw_opaque(const DrawList& list, const View& view, ShadowKind kind, bool whole) const {
  gl.Disable(GL_BLEND);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthMask(GL_TRUE);
  if (whole) {
    gl.Clear(GL_DEPTH_BUFFER_BIT);
  } else {
    // A part is cleared by drawing the background over it, at the greatest depth.
    gl.DepthFunc(GL_ALWAYS);
    draw_background(view);
  }
  gl.DepthFunc(GL_LEQUAL);
  gl.Enable(GL_CULL_FACE);
  gl.CullFace(GL_BACK);
  gl.FrontFace(GL_CW);
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, shadow_map.texture());
  for (const bool matte : {false, true}) {
    programs.use_surface(gl, kind, matte, view);
    for (const Batch& batch : list.opaque) {
      if (batch.matte == matte) draw_batch(batch, batch.count);
    }
  }
  gl.DepthMask(GL_FALSE);
  // Last, so that only what nothing hides is filled.
  if (whole) draw_background(view);
}

void Renderer::Impl::draw_blended(const DrawList& list, const View& view, const scene::Scene& scene, ShadowKind kind) {
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  bool surface_in_use = false;
  for (const BlendStep& step : list.blended) {
    if (step.quad < 0) {
      if (!surface_in_use) {
        gl.BindTexture(GL_TEXTURE_2D, shadow_map.texture());
        gl.Enable(GL_CULL_FACE);
        programs.use_surface(gl, kind, false, view);
      }
      surface_in_use = true;
      draw_batch(step.batch, step.batch.count);
      continue;
    }
    const scene::Quad& quad = scene.quads[static_cast<std::size_t>(step.quad)];
    surface_in_use = false;
    gl.Disable(GL_CULL_FACE);
    gl.BindTexture(GL_TEXTURE_2D, cache.texture(quad.texture).name);
    programs.use_quad(gl, view, quad);
    gl.BindVertexArray(empty_array);
    gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
  gl.Disable(GL_BLEND);
}

Result<Image> Renderer::Impl::picture(const scene::Scene& scene, const scene::Camera& camera,
                                      const RenderOptions& options, std::vector<float>* depth) {
  const View view = make_view(scene, camera, options.width, options.height);
  const ShadowKind kind = shadow_kind(options);
  std::vector<Item> items = items_of(scene, cache);
  if (kind != ShadowKind::kNone) update_shadows(scene, camera, items, view);
  Kept& one = kept_for(options);
  TROCAR_RETURN_IF_ERROR(one.target.bind(options.width, options.height, options.samples));
  const PixelBox all{0, 0, options.width, options.height};
  const bool whole = one.view != view || one.kind != kind;
  const std::vector<PixelBox> boxes = whole ? std::vector{all} : damage(one.items, items, scene, cache, view, kind);
  one.view.reset();
  const Window window{view.clip_from_world, view.width, view.height};
  for (const PixelBox& box : boxes) {
    const auto wanted = within(items, window, box, [](const Item&) { return true; });
    const DrawList list = make_draw_list(scene, camera, cache, wanted);
    upload_instances(list);
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(box.left, box.top, box.right - box.left, box.bottom - box.top);
    draw_opaque(list, view, kind, box.area() == all.area());
    draw_blended(list, view, scene, kind);
    gl.Disable(GL_SCISSOR_TEST);
  }
  Image image = one.target.read(boxes);
  if (depth != nullptr) *depth = one.target.read_depth();
  one.items = std::move(items);
  one.view = view;
  one.kind = kind;
  cache.drop_unused();
  return image;
}

Result<Renderer> Renderer::create() {
  // Frame buffer 0 is never drawn to.
  TROCAR_ASSIGN_OR_RETURN(OsmesaContext context, OsmesaContext::create(1, 1));
  auto impl = std::make_unique<Impl>(std::move(context));
  TROCAR_ASSIGN_OR_RETURN(impl->programs, Programs::link(impl->gl));
  return Renderer(std::move(impl));
}

Renderer::Renderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

namespace {

Status check(const RenderOptions& options) {
  if (options.width < 1 || options.height < 1 || options.width > kSizeLimit || options.height > kSizeLimit) {
    return fail(ErrorCode::kInvalidArgument, "a picture is 1 to 8192 pixels wide and high");
  }
  if (options.samples != 1 && options.samples != 2 && options.samples != 4) {
    return fail(ErrorCode::kInvalidArgument, "a picture has 1, 2 or 4 samples a pixel");
  }
  return {};
}

/// From the depth buffer's number to metres along z; infinite for the background's.
float metres(float depth, const scene::Camera& camera) {
  if (depth >= 1.0F) return std::numeric_limits<float>::infinity();
  const auto near = static_cast<float>(camera.near_m);
  const auto far = static_cast<float>(camera.far_m);
  if (camera.orthographic) return near + depth * (far - near);
  return near * far / (far - depth * (far - near));
}

}  // namespace

Result<Image> Renderer::draw(const scene::Scene& scene, const scene::Camera& camera, const RenderOptions& options) {
  TROCAR_RETURN_IF_ERROR(check(options));
  return impl_->picture(scene, camera, options, nullptr);
}

Result<DeepPicture> Renderer::draw_deep(const scene::Scene& scene, const scene::Camera& camera,
                                        const RenderOptions& options) {
  TROCAR_RETURN_IF_ERROR(check(options));
  DeepPicture picture;
  TROCAR_ASSIGN_OR_RETURN(picture.image, impl_->picture(scene, camera, options, &picture.depth_m));
  for (float& depth : picture.depth_m) depth = metres(depth, camera);
  return picture;
}

void Renderer::warm_up() {
  // One small thing of each kind: a triangle, a see-through one and a picture, with every kind of shadow.
  auto mesh = std::make_shared<scene::Mesh>();
  mesh->positions = {{0.0F, 0.0F, 0.0F}, {0.01F, 0.0F, 0.0F}, {0.0F, 0.01F, 0.0F}};
  mesh->normals.assign(3, Eigen::Vector3f::UnitZ());
  mesh->indices = {0, 1, 2};
  scene::Scene scene;
  scene.nodes.resize(2);
  for (scene::Node& node : scene.nodes) node.mesh = mesh;
  scene.nodes[1].material.base_colour.w() = 0.5F;
  scene.quads.resize(1);
  scene.quads[0].texture = std::make_shared<const Image>(2, 2);
  const scene::Camera camera = scene::Camera::look_at({0.0, 0.0, 0.1}, {0.0, 0.0, 0.0});
  for (const bool soft : {false, true}) {
    for (const int samples : {1, 4}) {
      const Result<Image> ignored = draw(scene, camera, {64, 64, samples, true, soft});
      if (!ignored) return;  // The first real picture will say why.
    }
  }
}

std::string Renderer::description() const {
  return impl_->context.description();
}

}  // namespace trocar::render
