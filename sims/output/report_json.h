// Reports as JSON: what a remodel, an improvement or a step did.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "kernel/audit.h"
#include "sims/tracking/surface_tracker.h"
#include "surgery/model/options.h"
#include "surgery/model/report.h"

namespace suture::sims {

struct FluidFrame;
struct ModuleCost;

/// Every field of the report but the vertex map. `reproducer` names the file that holds the mesh of
/// a refused surgery, if one was saved.
nlohmann::json to_json(const SurgeryReport& report, const std::string& reproducer = {});
nlohmann::json to_json(const QualityReport& report);
nlohmann::json to_json(const Audit& audit);
nlohmann::json to_json(const TrackerOptions& options);
nlohmann::json to_json(const TrackerCost& cost);
nlohmann::json to_json(const FluidFrame& frame);
nlohmann::json to_json(const std::vector<ModuleCost>& costs);

/// Counts, volume, area, components, Euler characteristic, angles and edge lengths of a surface.
nlohmann::json measured(const Triangles& surface);

}  // namespace suture::sims
