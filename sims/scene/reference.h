// The reference of every key that a scene may have, made from the tables of options.
#pragma once

#include <string>
#include <vector>

#include "kernel/option.h"

namespace suture::sims {

/// Keys of one table of a scene. A table has several of these where what it is decides its keys.
struct ReferenceSection {
  std::string table;  ///< as in "fluid.viscosity"; empty: the keys before any table
  std::string words;  ///< what the table is, or when it has these keys
  std::vector<OptionInfo> keys;
};

/// All sections, in the order of the page.
std::vector<ReferenceSection> scene_reference();

/// The page in Markdown.
std::string reference_page();

}  // namespace suture::sims
