"""Which runs the fluid's figures are made of: each a scene and what `suture run` is told."""

TRACKERS = {  # Figure 7's, and the paper's other extreme
    "mesh": [],
    "level_set": ["--method", "level_set", "--set", "method.advection=mac_cormack"],
    "particle_level_set": ["--method", "particle_level_set"],
    "semi_lagrangian_contouring": ["--method", "semi_lagrangian_contouring"],
}


def settings(changes):
    return [word for key, value in changes.items() for word in ("--set", f"{key}={value}")]


def plan_of(config):
    """Runs by name: FIGURE.TRACKER."""
    runs = {}

    def add(figure, tracker, words):
        runs[f"{figure}.{tracker}"] = {
            "scene": figure, "arguments": words + settings(config["changes"].get(figure, {}))}

    for tracker, words in TRACKERS.items():
        add("figure_7", tracker, words)
    for figure in ("figure_1", "figure_8", "figure_10"):
        add(figure, "mesh", [])
    # Bodies that meet do not merge: sheets stay between them, and are stretched and crumpled without end. After
    # 0.4 s these take more and more triangles, and ever shorter steps.
    add("figure_10", "mesh_without_topology", ["--method", "mesh_without_topology", *settings({"time.end": 0.4})])
    return {name: run for name, run in runs.items() if name not in config.get("without", [])}
