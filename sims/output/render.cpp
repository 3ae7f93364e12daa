// A surface drawn to a PNG file by VTK, in a context of EGL's that needs no display.
#include "sims/output/render.h"

// GLEW must come before any other header of OpenGL's.
#include <GL/glew.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkClipPolyData.h>
#include <vtkFloatArray.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkImageAppend.h>
#include <vtkImageData.h>
#include <vtkImageResize.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPNGWriter.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderer.h>
#include <vtkSSAOPass.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>
#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

#include "kernel/errors.h"
#include "kernel/files.h"
#include "sims/output/corner_normals.h"

namespace suture::sims {
namespace {

// Drawn this many times larger on each axis and shrunk again, which smooths edges.
constexpr int kOversampling = 2;
constexpr double kFilled = 0.9;     // share of the picture that what is shown may fill
constexpr int kLargestSide = 8192;  // pixels drawn on a side; what software renderers allow

/// An OpenGL context without window or display, current for as long as it lives.
class Context {
 public:
  Context() {
    display_ = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    EGLint major = 0, minor = 0, found = 0;
    if (display_ == EGL_NO_DISPLAY || eglInitialize(display_, &major, &minor) == EGL_FALSE)
      fail("EGL cannot be started without a display");
    constexpr EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                 EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    constexpr EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 2,
                                  EGL_NONE};
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE ||
        eglChooseConfig(display_, wanted, &config, 1, &found) == EGL_FALSE || found == 0)
      fail("EGL offers no OpenGL here");
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version);
    if (context_ == EGL_NO_CONTEXT ||
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE)
      fail("EGL has no OpenGL 3.2 here");
  }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  ~Context() { close(); }

 private:
  [[noreturn]] void fail(const std::string& what) {
    close();
    throw InvalidInput("cannot draw: " + what +
                       "; install libegl-mesa0 and libgl1-mesa-dri, or ask for no pictures");
  }
  void close() {
    if (display_ == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
    eglTerminate(display_);
  }

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

/// VTK's window for a foreign context. GLEW looks for X after it has found every function, and its
/// complaint that there is none must not stop VTK.
class Window : public vtkGenericOpenGLRenderWindow {
 public:
  static Window* New();
  vtkTypeMacro(Window, vtkGenericOpenGLRenderWindow)

      void OpenGLInitContext() override {
    ContextCreationTime.Modified();
    if (Initialized) return;
    const GLenum result = glewInit();
    GlewInitValid = result == GLEW_OK || result == GLEW_ERROR_NO_GLX_DISPLAY;
    Initialized = true;
  }
};
vtkStandardNewMacro(Window);

/// Three points of its own for each triangle, so that normals may differ across sharp edges.
vtkSmartPointer<vtkPolyData> to_poly_data(const Triangles& surface, const TriangleColours& colours,
                                          double feature_angle) {
  const auto corners = corner_normals(surface, feature_angle);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  vtkNew<vtkCellArray> cells;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto first = static_cast<vtkIdType>(3 * t);
    for (std::size_t i = 0; i < 3; ++i) {
      points->InsertNextPoint(surface.positions[surface.triangles[t][i]].data());
      normals->InsertNextTuple(corners[t][i].data());
    }
    cells->InsertNextCell({first, first + 1, first + 2});
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetPointData()->SetNormals(normals);
  if (colours.empty()) return data;
  vtkNew<vtkUnsignedCharArray> bytes;
  bytes->SetNumberOfComponents(3);
  for (const Eigen::Vector3f& c : colours)
    bytes->InsertNextTuple3(255 * c[0], 255 * c[1], 255 * c[2]);
  data->GetCellData()->SetScalars(bytes);
  return data;
}

vtkSmartPointer<vtkPolyData> cut(vtkPolyData* data, const CutPlane& where) {
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(where.point.data());
  plane->SetNormal(where.normal.data());
  vtkNew<vtkClipPolyData> clip;
  clip->SetInputData(data);
  clip->SetClipFunction(plane);
  clip->InsideOutOn();
  clip->Update();
  return clip->GetOutput();
}

void add_surface(vtkRenderer* renderer, vtkPolyData* data, const PictureOptions& options) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkProperty* look = actor->GetProperty();
  look->SetColor(0.80, 0.83, 0.86);
  look->SetAmbient(0.34);
  look->SetDiffuse(0.80);
  look->SetSpecular(0.14);
  look->SetSpecularPower(30);
  look->BackfaceCullingOn();
  if (options.edges) {
    look->EdgeVisibilityOn();
    look->SetEdgeColor(0.24, 0.25, 0.29);
    look->SetLineWidth(static_cast<float>(kOversampling) * 0.7f);
  }
  renderer->AddActor(actor);
}

/// Triangles seen from behind are the inside of the material, and only a cut shows them. Drawn in
/// one flat colour they look like the solid's section, without any need to make one.
void add_section(vtkRenderer* renderer, vtkPolyData* data) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkProperty* look = actor->GetProperty();
  look->SetColor(0.80, 0.38, 0.27);
  look->LightingOff();
  look->FrontfaceCullingOn();
  renderer->AddActor(actor);
}

void add_light(vtkRenderer* renderer, const Point& from, double intensity, const Point& colour) {
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(from[0], from[1], from[2]);
  light->SetFocalPoint(0, 0, 0);
  light->SetIntensity(intensity);
  light->SetColor(colour[0], colour[1], colour[2]);
  renderer->AddLight(light);
}

/// A warm key from the upper left, a cool fill from the right, a rim light from behind, and what a
/// light floor would throw back from below.
void light_studio(vtkRenderer* renderer) {
  renderer->AutomaticLightCreationOff();
  add_light(renderer, {-0.7, 1.0, 0.9}, 0.80, {1.0, 0.98, 0.95});
  add_light(renderer, {1.2, 0.15, 0.7}, 0.36, {0.84, 0.91, 1.0});
  add_light(renderer, {0.2, 0.9, -1.2}, 0.35, {1.0, 1.0, 1.0});
  add_light(renderer, {-0.3, -1.0, 0.6}, 0.16, {0.95, 0.95, 1.0});
  renderer->SetBackground(0.90, 0.91, 0.925);
  renderer->SetBackground2(0.985, 0.985, 0.99);
  renderer->GradientBackgroundOn();
}

/// Points the camera and \return the radius of what it shows, in the scene's unit.
double aim(vtkRenderer* renderer, const Box& box, const PictureOptions& options) {
  const Point centre = (box.low + box.high) / 2;
  const double half = (box.high - box.low).norm() / 2;
  const double radius = half > 0 ? half : 1;
  const Point direction = options.direction.normalized();
  const Point right = direction.cross(options.up).normalized(), up = right.cross(direction);
  const double tangent = std::tan(options.view_angle * std::numbers::pi / 360) * kFilled;
  const double aspect = static_cast<double>(options.width) / options.height;
  double distance = 0;  // the least from which every corner of the box is in the picture
  for (int corner = 0; corner < 8; ++corner) {
    Point p;
    for (int axis = 0; axis < 3; ++axis)
      p[axis] = ((corner >> axis & 1) != 0 ? box.high : box.low)[axis] - centre[axis];
    const double across = std::max(std::abs(right.dot(p)) / aspect, std::abs(up.dot(p))) / tangent;
    distance = std::max(distance, across - direction.dot(p));
  }
  distance = std::max(distance, radius) / options.zoom;
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(centre.data());
  const Point eye = centre - distance * direction;
  camera->SetPosition(eye.data());
  camera->SetViewUp(options.up.data());
  camera->SetViewAngle(options.view_angle);
  renderer->ResetCameraClippingRange();
  return radius;
}

/// Corners darken with what hides them, which shows depth better than light alone.
void shade_corners(vtkRenderer* renderer, double radius) {
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkSSAOPass> shading;
  shading->SetRadius(0.12 * radius);
  shading->SetBias(0.0015 * radius);
  shading->SetKernelSize(96);
  shading->BlurOn();
  shading->SetDelegatePass(steps);
  renderer->SetPass(shading);
}

void check(const Triangles& surface, const TriangleColours& colours,
           const PictureOptions& options) {
  const int largest = kLargestSide / kOversampling;
  if (options.width < 16 || options.height < 16 || options.width > largest ||
      options.height > largest)
    throw InvalidInput("a picture of " + std::to_string(options.width) + " × " +
                       std::to_string(options.height) + " pixels cannot be drawn; give 16 to " +
                       std::to_string(largest) + " on each side");
  const Point across = options.direction.normalized().cross(options.up.normalized());
  if (!across.allFinite() || !(across.norm() > 1e-6))
    throw InvalidInput("the camera's direction and up must be two different directions");
  if (!colours.empty() && colours.size() != surface.triangles.size())
    throw InvalidInput("there must be one colour for each triangle, or none");
}

void add_label(vtkRenderer* renderer, const std::string& text, int height) {
  vtkNew<vtkTextActor> label;
  label->SetInput(text.c_str());
  vtkTextProperty* look = label->GetTextProperty();
  look->SetColor(0.15, 0.16, 0.2);
  look->SetFontSize(std::max(10, height / 24) * kOversampling);
  look->SetJustificationToCentered();
  look->SetVerticalJustificationToTop();
  label->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  label->SetPosition(0.5, 0.97);
  renderer->AddActor2D(label);
}

/// One panel's picture. \pre a context is current
vtkSmartPointer<vtkImageData> draw(const Panel& panel, const PictureOptions& options) {
  vtkNew<Window> window;
  window->SetOwnContext(0);
  window->SetIsCurrent(true);
  window->SetReadyForRendering(true);
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(kOversampling * options.width, kOversampling * options.height);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  light_studio(renderer);
  const Triangles& surface = *panel.surface;
  if (!surface.triangles.empty()) {
    auto data = to_poly_data(surface, panel.colours, options.feature_angle);
    if (options.cut) data = cut(data, *options.cut);
    add_surface(renderer, data, options);
    if (options.cut) add_section(renderer, data);
    const Box box = options.fit ? *options.fit : bounding_box(surface.positions);
    shade_corners(renderer, aim(renderer, box, options));
  }
  if (!panel.label.empty()) add_label(renderer, panel.label, options.height);
  window->Render();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  vtkNew<vtkImageResize> shrink;
  shrink->SetInputConnection(grab->GetOutputPort());
  shrink->SetResizeMethodToOutputDimensions();
  shrink->SetOutputDimensions(options.width, options.height, 1);
  shrink->Update();
  vtkSmartPointer<vtkImageData> image = shrink->GetOutput();
  window->Finalize();
  return image;
}

void write_png(vtkImageData* image, const std::filesystem::path& file) {
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  write_file(file, {reinterpret_cast<const char*>(bytes->GetPointer(0)),
                    static_cast<std::size_t>(bytes->GetNumberOfValues())});
}

}  // namespace

void render_png(const Triangles& surface, const TriangleColours& colours,
                const PictureOptions& options, const std::filesystem::path& file) {
  check(surface, colours, options);
  const Context context;
  write_png(draw({&surface, colours, ""}, options), file);
}

void render_panels(const std::vector<Panel>& panels, const PanelOptions& layout,
                   const PictureOptions& options, const std::filesystem::path& file) {
  if (panels.empty() || layout.columns < 1)
    throw InvalidInput("a picture of several surfaces needs one at least, and a column");
  for (const Panel& panel : panels) check(*panel.surface, panel.colours, options);
  const Context context;
  vtkNew<vtkImageAppend> rows;
  rows->SetAppendAxis(1);
  const auto columns = static_cast<std::size_t>(layout.columns);
  const std::size_t count = (panels.size() + columns - 1) / columns;
  const Triangles nothing;
  for (std::size_t row = count; row-- > 0;) {  // an image's first row is its lowest
    vtkNew<vtkImageAppend> across;
    for (std::size_t i = row * columns; i < (row + 1) * columns; ++i)
      across->AddInputData(draw(i < panels.size() ? panels[i] : Panel{&nothing, {}, ""}, options));
    across->Update();
    rows->AddInputData(across->GetOutput());
  }
  rows->Update();
  write_png(rows->GetOutput(), file);
}

}  // namespace suture::sims
