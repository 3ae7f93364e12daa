// The tables of the motions' parameters: meaning, unit, range and source of each.
#include "sims/flows/motion_options.h"

namespace suture::sims {
namespace {

constexpr std::array<Named<EnrightVariant>, 2> kVariants = {
    {{"leveque", EnrightVariant::leveque}, {"eltopo", EnrightVariant::eltopo}}};

const OptionTable<BodiesParameters> kBodies(
    "motion", {{"relaxation",
                &BodiesParameters::relaxation,
                {.meaning = "time in which what has merged comes to move as one",
                 .unit = unit::time,
                 .range = Range::above(0)}}});

using C = CurlNoiseParameters;
const OptionTable<C> kCurlNoise(
    "motion",
    {{"seed", &C::seed, {.meaning = "seed of the random waves", .range = Range::at_least(0)}},
     {"waves", &C::waves, {.meaning = "number of waves", .range = Range::between(1, 10000)}},
     {"wavelength",
      &C::wavelength,
      {.meaning = "length of the longest waves; the shortest are half of it",
       .unit = unit::length,
       .range = Range::above(0)}},
     {"speed",
      &C::speed,
      {.meaning = "root mean square of the speed, far from where it fades", .unit = unit::speed}},
     {"period",
      &C::period,
      {.meaning = "time in which the longest waves pass; 0: the field is steady",
       .unit = unit::time,
       .range = Range::at_least(0)}},
     {"centre",
      &C::centre,
      {.meaning = "centre of the ball in which the field lives", .unit = unit::length}},
     {"radius",
      &C::radius,
      {.meaning = "radius of that ball; 0: the field is everywhere",
       .unit = unit::length,
       .range = Range::at_least(0)}}});

using E = EnrightParameters;
const OptionTable<E> kEnright(
    "motion",
    {{"variant",
      {&E::variant, kVariants},
      {.meaning = "course in time: as published, or starting and turning at rest",
       .source = "Enright et al. 2002"}},
     {"period",
      &E::period,
      {.meaning = "time at which all is back", .unit = unit::time, .range = Range::above(0)}}});

using F = FoldParameters;
const OptionTable<F> kFold(
    "motion", {{"centre", &F::centre, {.meaning = "point that stays", .unit = unit::length}},
               {"axis", &F::axis, {.meaning = "direction of the compression"}},
               {"up", &F::up, {.meaning = "direction of the wave, at right angles to axis"}},
               {"rate", &F::rate, {.meaning = "rate of the compression", .unit = unit::rate}},
               {"amplitude", &F::amplitude, {.meaning = "speed of the wave", .unit = unit::speed}},
               {"wavelength",
                &F::wavelength,
                {.meaning = "length of the wave at time 0",
                 .unit = unit::length,
                 .range = Range::above(0)}}});

const OptionTable<MeanCurvatureParameters> kMeanCurvature(
    "motion", {{"rate",
                &MeanCurvatureParameters::rate,
                {.meaning = "speed inwards per curvature",
                 .unit = unit::area_rate,
                 .range = Range::above(0)}}});

const OptionTable<NormalFlowParameters> kNormalFlow(
    "motion", {{"speed",
                &NormalFlowParameters::speed,
                {.meaning = "speed along the outward normal", .unit = unit::speed}}});

const OptionTable<ReversalParameters> kReversal(
    "motion", {{"reversal",
                &ReversalParameters::reversal,
                {.meaning = "time at which all is back in place, by the same way; 0: the field is "
                            "not reversed",
                 .unit = unit::time,
                 .range = Range::at_least(0)}}});

using R = RotationParameters;
const OptionTable<R> kRotation(
    "motion",
    {{"centre", &R::centre, {.meaning = "point on the axis", .unit = unit::length}},
     {"axis", &R::axis, {.meaning = "direction of the axis"}},
     {"rate", &R::rate, {.meaning = "angular velocity", .unit = {"radians/time", 0, -1}}}});

using S = StretchParameters;
const OptionTable<S> kStretch(
    "motion",
    {{"centre", &S::centre, {.meaning = "point that stays", .unit = unit::length}},
     {"axis", &S::axis, {.meaning = "direction of the stretch"}},
     {"rate", &S::rate, {.meaning = "rate of the stretch", .unit = unit::rate}},
     {"width",
      &S::width,
      {.meaning = "beyond it the ends move almost rigidly; 0: the field is linear everywhere",
       .unit = unit::length,
       .range = Range::at_least(0)}}});

const OptionTable<TranslationParameters> kTranslation(
    "motion", {{"velocity",
                &TranslationParameters::velocity,
                {.meaning = "velocity of everything", .unit = unit::speed}}});

}  // namespace

const OptionTable<BodiesParameters>& bodies_parameters() { return kBodies; }
const OptionTable<CurlNoiseParameters>& curl_noise_parameters() { return kCurlNoise; }
const OptionTable<EnrightParameters>& enright_parameters() { return kEnright; }
const OptionTable<FoldParameters>& fold_parameters() { return kFold; }
const OptionTable<MeanCurvatureParameters>& mean_curvature_parameters() { return kMeanCurvature; }
const OptionTable<NormalFlowParameters>& normal_flow_parameters() { return kNormalFlow; }
const OptionTable<ReversalParameters>& reversal_parameters() { return kReversal; }
const OptionTable<RotationParameters>& rotation_parameters() { return kRotation; }
const OptionTable<StretchParameters>& stretch_parameters() { return kStretch; }
const OptionTable<TranslationParameters>& translation_parameters() { return kTranslation; }

}  // namespace suture::sims
