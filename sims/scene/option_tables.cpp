// What a scene says of its bodies, of time, of what is written and what is measured, as options.
#include "sims/scene/option_tables.h"

#include <cmath>

#include "sims/flows/motions.h"

namespace suture::sims {
namespace {

constexpr std::array<Named<Fit>, 3> kFits = {
    {{"first", Fit::first}, {"each", Fit::each}, {"box", Fit::box}}};
constexpr std::array<Named<Colour>, 3> kColours = {
    {{"plain", Colour::plain}, {"patches", Colour::patches}, {"components", Colour::components}}};
constexpr double kMostCopies = 1e6;  // beyond it a count is surely a slip

const Range kCount = Range::at_least(0);

const OptionTable<TitleOptions> kTitle("", {{"title",
                                             &TitleOptions::title,
                                             {.meaning = "what the scene is called in reports",
                                              .otherwise = "the file's name"}}});

using T = TimeOptions;
const OptionTable<T> kTime("time", {{"step",
                                     &T::step,
                                     {.meaning = "time step; with a fluid, the time of a frame",
                                      .unit = unit::time,
                                      .range = Range::above(0),
                                      .required = true,
                                      .source = "§4"}},
                                    {"end",
                                     &T::end,
                                     {.meaning = "time at which the run ends",
                                      .unit = unit::time,
                                      .range = Range::at_least(0),
                                      .required = true}},
                                    {"remodel_every",
                                     &T::remodel_every,
                                     {.meaning = "steps between changes of topology; 0: never",
                                      .unit = unit::steps,
                                      .range = kCount,
                                      .source = "§3"}},
                                    {"improve_every",
                                     &T::improve_every,
                                     {.meaning = "steps between improvements of the mesh; 0: never",
                                      .unit = unit::steps,
                                      .range = kCount,
                                      .source = "§6.2"}}});

using O = OutputOptions;
const OptionInfo kEvery{.meaning =
                            "steps between two that are written; the first and the last "
                            "always are, where any is; 0: none but those in `at`",
                        .unit = unit::steps,
                        .range = kCount};
const OptionInfo kAt{.meaning = "times at which one is written besides",
                     .unit = unit::time,
                     .range = Range::at_least(0)};

const OptionTable<O> kMeshes("meshes", {{"every", inside(&O::meshes, &Every::steps), kEvery},
                                        {"at", inside(&O::meshes, &Every::at), kAt},
                                        {"format",
                                         {&O::mesh_format, {"obj", "off", "ply", "stl"}},
                                         {.meaning = "format of the meshes"}}});

using P = PictureOptions;
const Range kPixels = Range::between(16, 4096);
const OptionTable<O> kPictures(
    "pictures",
    {{"every", inside(&O::pictures, &Every::steps), kEvery},
     {"at", inside(&O::pictures, &Every::at), kAt},
     {"width",
      inside(&O::picture, &P::width),
      {.meaning = "width of a picture", .unit = unit::pixels, .range = kPixels}},
     {"height",
      inside(&O::picture, &P::height),
      {.meaning = "height of a picture", .unit = unit::pixels, .range = kPixels}},
     {"colour",
      {&O::colour, kColours},
      {.meaning = "what colours tell: nothing, what surgery made, or the components"}},
     {"patch_fading",
      &O::patch_fading,
      {.meaning = "time in which the colour of what surgery made fades; 0: a tenth of the run",
       .unit = unit::time,
       .range = Range::at_least(0)}},
     {"edges", inside(&O::picture, &P::edges), {.meaning = "edges of triangles are drawn"}},
     {"feature_angle",
      inside(&O::picture, &P::feature_angle),
      {.meaning = "edges between normals further apart are drawn sharp",
       .unit = unit::degrees,
       .range = Range::between(0, 180)}},
     {"direction", inside(&O::picture, &P::direction), {.meaning = "the way the camera looks"}},
     {"up", inside(&O::picture, &P::up), {.meaning = "what is up in a picture"}},
     {"view_angle",
      inside(&O::picture, &P::view_angle),
      {.meaning = "the camera's angle from bottom to top",
       .unit = unit::degrees,
       .range = Range::between(1, 120)}},
     {"zoom",
      inside(&O::picture, &P::zoom),
      {.meaning = "above 1: closer than what fits everything", .range = Range::above(0)}},
     {"fit",
      {&O::fit, kFits},
      {.meaning = "what the camera keeps in view: the first surface, each as it is, or a box"}},
     {"low",
      inside(&O::box, &Box::low),
      {.meaning = "with fit = box only: a corner of the box", .unit = unit::length}},
     {"high",
      inside(&O::box, &Box::high),
      {.meaning = "the corner across, each number above that of low", .unit = unit::length}},
     {"cut_point",
      &O::cut_point,
      {.meaning = "a point of a plane that cuts the surface",
       .unit = unit::length,
       .otherwise = "no cut, or [0, 0, 0] where cut_normal is given"}},
     {"cut_normal",
      &O::cut_normal,
      {.meaning = "normal of that plane, towards what is cut away",
       .otherwise = "no cut, or [0, 1, 0] where cut_point is given"}}});

using M = MeasureOptions;
const Range kWhole = Range::between(-1e9, 1e9);
const OptionTable<M> kMeasure(
    "measure",
    {{"at",
      &M::at,
      {.meaning = "times to measure at; none: the end",
       .unit = unit::time,
       .range = Range::at_least(0)}},
     {"reference",
      {&M::reference, {"exact", "polyhedron", "none"}},
      {.meaning = "what is right: the shape itself carried by the flow, the start mesh so "
                  "carried, or nothing"}},
     {"domain",
      &M::domain,
      {.meaning = "side of the domain, for the table; 0: none is known",
       .unit = unit::length,
       .range = Range::at_least(0)}},
     {"tolerance",
      &M::tolerance,
      {.meaning = "error of the chords of an exact reference; 0: a thousandth of a cell",
       .unit = unit::length,
       .range = Range::at_least(0)}},
     {"components",
      &M::components,
      {.meaning = "right number of components",
       .range = kWhole,
       .otherwise = "that of the first surface"}},
     {"euler",
      &M::euler,
      {.meaning = "right Euler characteristic",
       .range = kWhole,
       .otherwise = "that of the first surface"}},
     {"until_components",
      &M::until_components,
      {.meaning = "the run ends once no more components than this are left; 0: at its end",
       .range = Range::between(0, 1e9)}}});

const OptionTable<PhaseOptions> kPhase(
    "motion",
    {{"kind",
      {&PhaseOptions::kind, motion_names()},
      {.meaning = "what moves the surface; each kind has keys of its own", .required = true}},
     {"until",
      &PhaseOptions::until,
      {.meaning = "with [[motion]] given several times: time at which the next one takes "
                  "over, later than that of the one before",
       .unit = unit::time,
       .range = Range::above(0),
       .otherwise = "required of all but the last"}}});

using S = PlacedOptions;
const OptionTable<S> kPlaced(
    "bodies",
    {{"shape", &S::shape, {.meaning = "a shape that Suture makes; one of shape, mesh and model"}},
     {"mesh", &S::mesh, {.meaning = "a mesh file, beside the scene's"}},
     {"model", &S::model, {.meaning = "a model in $SUTURE_MODELS or data/models"}},
     {"fallback", &S::fallback, {.meaning = "a shape for where the model is not there"}},
     {"fallback_rotate",
      &S::fallback_rotate,
      {.meaning = "turn of that shape", .unit = unit::degrees}},
     {"fallback_rotate_axis", &S::fallback_rotate_axis, {.meaning = "axis of that turn"}},
     {"repair", &S::repair, {.meaning = "what has one right answer is mended"}},
     {"normalise",
      &S::normalise,
      {.meaning = "the surface is centred, and its longest side scaled to 1"}},
     {"scale", &S::scale, {.meaning = "factor of all lengths", .range = Range::above(0)}},
     {"rotate", &S::rotate, {.meaning = "turn after scaling", .unit = unit::degrees}},
     {"rotate_axis", &S::rotate_axis, {.meaning = "axis of that turn"}},
     {"translate", &S::translate, {.meaning = "move after turning", .unit = unit::length}}});

using B = BodyOptions;
const OptionTable<B> kBody(
    "bodies",
    {{"velocity",
      &B::velocity,
      {.meaning = "velocity of the body: a fluid's at the start, or that of the motion `bodies`",
       .unit = unit::speed}},
     {"copies",
      &B::copies,
      {.meaning = "how many of the body there are", .range = Range::between(1, kMostCopies)}},
     {"scatter_seed",
      &B::scatter_seed,
      {.meaning = "seed of the random moves of the copies", .range = Range::at_least(0)}},
     {"scatter_low",
      &B::scatter_low,
      {.meaning = "least move of a copy along each axis", .unit = unit::length}},
     {"scatter_high",
      &B::scatter_high,
      {.meaning = "largest move of a copy along each axis",
       .unit = unit::length,
       .otherwise = "scatter_low"}}});

}  // namespace

std::int64_t TimeOptions::steps() const {
  // A quotient that rounding left just above a whole number is that number.
  constexpr double rounding = 1e-9;
  return static_cast<std::int64_t>(std::ceil(end / step * (1 - rounding)));
}

bool Every::wants(std::int64_t index, const TimeOptions& time) const {
  if (!any()) return false;
  if (index == 0 || index == time.steps()) return true;
  if (steps > 0 && index % steps == 0) return true;
  const double now = static_cast<double>(index) * time.step;
  for (const double t : at)
    if (std::abs(t - now) < 0.5 * time.step) return true;
  return false;
}

const OptionTable<TitleOptions>& title_options() { return kTitle; }
const OptionTable<TimeOptions>& time_options() { return kTime; }
const OptionTable<OutputOptions>& mesh_options() { return kMeshes; }
const OptionTable<OutputOptions>& picture_options() { return kPictures; }
const OptionTable<MeasureOptions>& measure_options() { return kMeasure; }
const OptionTable<PhaseOptions>& phase_options() { return kPhase; }
const OptionTable<PlacedOptions>& placed_options() { return kPlaced; }
const OptionTable<BodyOptions>& body_options() { return kBody; }

}  // namespace suture::sims
