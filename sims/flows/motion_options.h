// The tables of the motions' parameters: who adds one adds a field to its struct and a row here.
#pragma once

#include "kernel/option_table.h"
#include "sims/flows/fields.h"

namespace suture::sims {

struct TranslationParameters {
  Point velocity = Point::UnitX();
};

struct NormalFlowParameters {
  double speed = 1;  ///< outwards
};

struct MeanCurvatureParameters {
  double rate = 1;  ///< speed per curvature
};

struct BodiesParameters {
  double relaxation = 1;  ///< time in which what has merged comes to move as one
};

/// A parameter that most velocity fields have besides their own.
struct ReversalParameters {
  double reversal = 0;  ///< time at which all is back in place; 0: never
};

const OptionTable<BodiesParameters>& bodies_parameters();
const OptionTable<CurlNoiseParameters>& curl_noise_parameters();
const OptionTable<EnrightParameters>& enright_parameters();
const OptionTable<FoldParameters>& fold_parameters();
const OptionTable<MeanCurvatureParameters>& mean_curvature_parameters();
const OptionTable<NormalFlowParameters>& normal_flow_parameters();
const OptionTable<ReversalParameters>& reversal_parameters();
const OptionTable<RotationParameters>& rotation_parameters();
const OptionTable<StretchParameters>& stretch_parameters();
const OptionTable<TranslationParameters>& translation_parameters();

}  // namespace suture::sims
