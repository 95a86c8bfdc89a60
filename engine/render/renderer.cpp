#include "engine/render/renderer.h"

#include <optional>
#include <utility>

#include "engine/render/draw_list.h"
#include "engine/render/frame_target.h"
#include "engine/render/mesh_cache.h"
#include "engine/render/osmesa_context.h"
#include "engine/render/programs.h"

namespace trocar::render {
namespace {

constexpr int kSizeLimit = 8192;

ShadowKind shadow_kind(const RenderOptions& options) {
  if (!options.shadows) return ShadowKind::kNone;
  return options.soft_shadows ? ShadowKind::kSoft : ShadowKind::kHard;
}

}  // namespace

struct Renderer::Impl {
  explicit Impl(OsmesaContext made) : context(std::move(made)), gl(context.gl()), cache(gl), frame(gl), shadow_map(gl) {
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

  void upload_instances(const DrawList& list) const;
  void draw_batch(const Batch& batch, std::size_t count) const;
  void draw_shadows(const DrawList& list, const View& view) const;
  void draw_opaque(const DrawList& list, const View& view, const scene::Scene& scene, ShadowKind kind) const;
  void draw_blended(const DrawList& list, const View& view, const scene::Scene& scene, ShadowKind kind);

  OsmesaContext context;  // First in, last out: everything below lives in it.
  const GlFunctions& gl;
  MeshCache cache;
  FrameTarget frame;
  ShadowMap shadow_map;
  Programs programs;
  GLuint instance_buffer = 0;
  GLuint empty_array = 0;
};

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

void Renderer::Impl::draw_shadows(const DrawList& list, const View& view) const {
  shadow_map.bind_for_drawing();
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthMask(GL_TRUE);
  gl.Enable(GL_CULL_FACE);
  gl.CullFace(GL_BACK);
  gl.FrontFace(GL_CW);
  gl.Clear(GL_DEPTH_BUFFER_BIT);
  // The outermost texels stay as cleared: they stand for all that is beyond.
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(1, 1, ShadowMap::kSize - 2, ShadowMap::kSize - 2);
  gl.Enable(GL_POLYGON_OFFSET_FILL);
  gl.PolygonOffset(1.5F, 4.0F);
  programs.use_shadow(gl, view);
  for (const Batch& batch : list.opaque) draw_batch(batch, batch.caster_count);
  gl.Disable(GL_POLYGON_OFFSET_FILL);
  gl.Disable(GL_SCISSOR_TEST);
}

void Renderer::Impl::draw_opaque(const DrawList& list, const View& view, const scene::Scene& scene,
                                 ShadowKind kind) const {
  gl.Disable(GL_BLEND);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LEQUAL);
  gl.DepthMask(GL_TRUE);
  gl.Enable(GL_CULL_FACE);
  gl.CullFace(GL_BACK);
  gl.FrontFace(GL_CW);
  gl.Clear(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT);
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, shadow_map.texture());
  for (const bool matte : {false, true}) {
    programs.use_surface(gl, kind, matte, view, scene);
    for (const Batch& batch : list.opaque) {
      if (batch.matte == matte) draw_batch(batch, batch.count);
    }
  }
  programs.use_background(gl, view, scene);
  gl.DepthMask(GL_FALSE);
  gl.Disable(GL_CULL_FACE);
  gl.BindVertexArray(empty_array);
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
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
        programs.use_surface(gl, kind, false, view, scene);
      }
      surface_in_use = true;
      draw_batch(step.batch, step.batch.count);
      continue;
    }
    const scene::Quad& quad = scene.quads[static_cast<std::size_t>(step.quad)];
    surface_in_use = false;
    gl.Disable(GL_CULL_FACE);
    gl.BindTexture(GL_TEXTURE_2D, cache.texture(quad.texture));
    programs.use_quad(gl, view, quad);
    gl.BindVertexArray(empty_array);
    gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
  gl.Disable(GL_BLEND);
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

Result<Image> Renderer::draw(const scene::Scene& scene, const scene::Camera& camera, const RenderOptions& options) {
  if (options.width < 1 || options.height < 1 || options.width > kSizeLimit || options.height > kSizeLimit) {
    return fail(ErrorCode::kInvalidArgument, "a picture is 1 to 8192 pixels wide and high");
  }
  if (options.samples != 1 && options.samples != 2 && options.samples != 4) {
    return fail(ErrorCode::kInvalidArgument, "a picture has 1, 2 or 4 samples a pixel");
  }
  Impl& impl = *impl_;
  const View view = make_view(scene, camera, options.width, options.height);
  const DrawList list = make_draw_list(scene, camera, impl.cache);
  const ShadowKind kind = shadow_kind(options);
  impl.upload_instances(list);
  if (kind != ShadowKind::kNone) impl.draw_shadows(list, view);
  TROCAR_RETURN_IF_ERROR(impl.frame.bind(options.width, options.height, options.samples));
  impl.draw_opaque(list, view, scene, kind);
  impl.draw_blended(list, view, scene, kind);
  Image image = impl.frame.read();
  impl.cache.drop_unused();
  return image;
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
