// Refusals are counted by the rule that made them.
#include "surgery/collapse/rules.h"

namespace suture::surgery {

void count_refusal(CollapseCounts& counts, Refusal refusal) {
  switch (refusal) {
    case Refusal::none:
      break;
    case Refusal::link:
      ++counts.refused_link;
      break;
    case Refusal::normal:
      ++counts.refused_normal;
      break;
    case Refusal::node:
      ++counts.refused_node;
      break;
    case Refusal::volume:
      ++counts.refused_volume;
      break;
    case Refusal::feature:
      ++counts.refused_feature;
      break;
    case Refusal::premature:
      ++counts.delayed;
      break;
  }
}

void add_to(CollapseCounts& sum, const CollapseCounts& counts) {
  sum.done += counts.done;
  sum.delayed += counts.delayed;
  sum.blocked += counts.blocked;
  sum.refused_link += counts.refused_link;
  sum.refused_normal += counts.refused_normal;
  sum.refused_node += counts.refused_node;
  sum.refused_volume += counts.refused_volume;
  sum.refused_feature += counts.refused_feature;
}

}  // namespace suture::surgery
