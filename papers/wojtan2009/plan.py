"""Which runs the comparison is made of: each a name and what `suture measure` is told."""

METHODS = {  # the baselines as their authors' papers and libraries have them
    "level_set": ["--method", "level_set"],
    "level_set_mac_cormack": ["--method", "level_set", "--set", "method.advection=mac_cormack"],
    "particle_level_set": ["--method", "particle_level_set"],
    "particle_level_set_weno": ["--method", "particle_level_set", "--set", "method.version=weno",
                                "--set", "method.particle_order=3"],
    "semi_lagrangian_contouring": ["--method", "semi_lagrangian_contouring"],
}
MESHES = {"mesh": ["--method", "mesh"], "mesh_without_topology": ["--method", "mesh_without_topology"],
          "markers": ["--method", "markers"]}
FIGURES = ("level_set", "particle_level_set_weno", "semi_lagrangian_contouring", "mesh")
DOMAINS = {"zalesak": 100, "enright": 1, "enright_eltopo": 1, "translation": 1, "shear": 1,
           "curl_noise": 5}


def setting(key, value):
    return ["--set", f"{key}={value:.10g}" if isinstance(value, float) else f"{key}={value}"]


def cells(scene, resolution):
    return setting("tracker.cell_size", DOMAINS[scene] / resolution)


class Plan:
    """Runs by name; `group` says which table they go to."""

    def __init__(self):
        self.runs = {}

    def add(self, group, name, scene, *arguments):
        flat = [word for part in arguments for word in part]
        self.runs[name] = {"group": group, "scene": scene, "arguments": flat}


def baselines(plan, config):
    for scene in ("zalesak", "enright"):
        for resolution in config["resolutions"]:
            for method, words in METHODS.items():
                plan.add(scene, f"{scene}.{method}.{resolution}", scene, words,
                         cells(scene, resolution))
    middle = config["resolution"]
    for scene in ("enright_eltopo", "translation", "shear", "curl_noise"):
        group = "enright" if scene == "enright_eltopo" else "others"
        for method, words in METHODS.items():
            plan.add(group, f"{scene}.{method}.{middle}", scene, words, cells(scene, middle))


def meshes(plan, config):
    middle = config["resolution"]
    for scene in DOMAINS:
        group = {"zalesak": "zalesak", "enright": "enright", "enright_eltopo": "enright"}.get(
            scene, "others")
        for method, words in MESHES.items():
            plan.add(group, f"{scene}.{method}.{middle}", scene, words, cells(scene, middle))
    for resolution in config["resolutions"]:
        if resolution != middle:
            plan.add("zalesak", f"zalesak.mesh.{resolution}", "zalesak", MESHES["mesh"],
                     cells("zalesak", resolution))
    for method in ("mesh", "markers"):  # against the start mesh itself: what moving it loses
        plan.add("zalesak", f"zalesak.{method}.polyhedron", "zalesak", MESHES[method],
                 cells("zalesak", middle), ["--reference", "polyhedron"])


def thin_sheet(plan, config):
    """Topology on, with cells that tear the stretched sheet (64³), and with cells that do not (100³)."""
    for resolution in config["sheet_resolutions"]:
        for events in ("merge", "split", "both", "none"):
            for depth in (0, 1, 2):
                plan.add("enright", f"sheet.{events}.depth{depth}.{resolution}", "enright",
                         MESHES["mesh"], cells("enright", resolution),
                         setting("tracker.events", events), setting("tracker.depth", depth))


def convergence(plan, config):
    for edge in config["edges"]:
        plan.add("convergence", f"edge.mesh.{edge}", "enright", MESHES["mesh"],
                 setting("quality.edge_length", 3.5 * edge), setting("quality.chord_error", 0.9 * edge ** 2),
                 setting("bodies.parameters.edge_length", edge))
        plan.add("convergence", f"edge.markers.{edge}", "enright", MESHES["markers"],
                 setting("bodies.parameters.edge_length", edge))
    for step in config["steps"]:
        for method in ("mesh", "markers"):
            plan.add("convergence", f"step.{method}.{step}", "enright", MESHES[method],
                     setting("time.step", step))
    for turns in config["turns"]:
        plan.add("convergence", f"turn.markers.{turns}", "zalesak", MESHES["markers"],
                 setting("time.step", 628 / turns))
    for resolution in config["cell_resolutions"]:
        for method, words in {**METHODS, "mesh": MESHES["mesh"]}.items():
            plan.add("convergence", f"cell.{method}.{resolution}", "enright", words,
                     cells("enright", resolution), ["--at", "3"])


def topology(plan, config):
    for scene in ("two_spheres", "dumbbell"):
        for method, words in {**METHODS, "mesh": MESHES["mesh"]}.items():
            plan.add("bodies", f"{scene}.{method}", scene, words)
    for count, seeds in ((100, config["seeds_100"]), (1000, config["seeds_1000"])):
        for seed in range(1, seeds + 1):
            plan.add("topology", f"spheres_{count}.{seed:03d}", f"spheres_{count}",
                     setting("bodies.scatter_seed", seed))


def sequences(plan, config):
    """Surfaces for the pictures of Enright's test; nothing is measured but their topology."""
    at = ["--at", ",".join(str(t) for t in config["sequence"]), "--reference", "none"]
    for method in FIGURES:
        words = METHODS.get(method) or MESHES[method]
        plan.add("pictures", f"sequence.{method}", "enright", words,
                 cells("enright", config["resolution"]), at)


def plan_of(config):
    plan = Plan()
    for part in (baselines, meshes, thin_sheet, convergence, topology, sequences):
        part(plan, config)
    for name in config.get("without", []):
        del plan.runs[name]
    for run in plan.runs.values():  # where references need not be as fine as the scenes ask
        if run["scene"] in config.get("tolerances", {}):
            run["arguments"] += setting("measure.tolerance", config["tolerances"][run["scene"]])
    return plan.runs
