// The table of the options of viscoelasticity.
#include "sims/fluid/effects/viscoelasticity.h"

namespace suture::sims {
namespace {

using E = ElasticOptions;
const OptionTable<E> kViscoelasticity(
    "fluid.viscoelasticity",
    {{"modulus",
      &E::modulus,
      {.meaning = "shear modulus: stress is twice this times the elastic strain",
       .unit = unit::pressure,
       .range = Range::at_least(0),
       .required = true,
       .source = "Goktekin et al. 2004"}},
     {"yield_strain",
      &E::yield_strain,
      {.meaning = "size of the deviatoric elastic strain beyond which the liquid flows",
       .range = Range::above(0).or_infinite(),
       .source = "Goktekin et al. 2004"}},
     {"flow_rate",
      &E::flow_rate,
      {.meaning = "rate at which strain beyond the yield strain decays; inf: at once",
       .unit = unit::rate,
       .range = Range::at_least(0).or_infinite(),
       .source = "Goktekin et al. 2004"}},
     {"relaxation_time",
      &E::relaxation_time,
      {.meaning = "time in which strain decays to 1/e; inf: it does not",
       .unit = unit::time,
       .range = Range::above(0).or_infinite()}},
     {"no_slip",
      &E::no_slip,
      {.meaning = "viscous liquid sticks to solids; else they only push",
       .otherwise = "that of [fluid.viscosity], or true"}}});

}  // namespace

const OptionTable<E>& viscoelasticity_options() { return kViscoelasticity; }

}  // namespace suture::sims
