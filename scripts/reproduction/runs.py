"""The runs of the reproduction: what the paper computed, with its settings and with the recommended ones."""
from study import Run

STIFFNESS = {"20MPa": 2e7, "200MPa": 2e8, "2GPa": 2e9, "20GPa": 2e10, "200GPa": 2e11, "rigid": None}
# Table 2 does not say which step went with which stiffness; these are the ones that its explicit solid can run
# (section "What the paper left open" of the page).
PAPER_SUBSTEP = {2e6: 1e-6, 2e7: 1e-6, 2e8: 1e-6, 2e9: 5e-7, 2e10: 5e-8, 2e11: 5e-8}
FRAMES = {"output.frame_interval": 0.02}

# The case has only defaults; these fix what the kept numbers were computed with.
RECOMMENDED = {"fluid.propagation_speed": 1.0, "fluid.courant": 0.3, "time.window": 1e-4, "coupling.scheme": "weak"}
PAPER = {"solid.model": "mps", "solid.mps.pairs": "paper", "solid.mps.viscosity": 0, "fluid.source": "deviation",
         "fluid.gradient": "p_min", "fluid.gamma": 0.01, "fluid.compressibility": 1e-9, "coupling.scheme": "weak",
         "coupling.load": "held", "time.stepping": "fixed", "time.window": 2e-5}
PUBLIC_CODE = {"fluid.gamma": 0.01, "fluid.compressibility": 1e-6}  # defaults of the first author's program


def plate(stiffness, model=None):
    """Table 2: steel's density and a Poisson's ratio; a rigid plate is a model."""
    if stiffness is None:
        return {"solid.model": "rigid"}
    settings = {"solid.density": 7800, "solid.poisson_ratio": 0.3, "solid.young_modulus": stiffness}
    return settings | ({"solid.model": model} if model else {})


def paper_plate(stiffness):
    if stiffness is None:
        return PAPER | plate(None)
    return PAPER | plate(stiffness) | {"solid.mps.substep": PAPER_SUBSTEP[stiffness]}


def dam_break(name, settings, spacing, end):
    if spacing == 0.004:  # does not divide the column's 146 mm
        settings = settings | {"fluid.water.0.max": "[0.148, 0.292]"}
    return Run(name, "dam_break_plate", RECOMMENDED | settings | {"fluid.spacing": spacing, "time.end": end} | FRAMES)


def verification():
    """Table 1: E = 1 MPa."""
    words = PAPER | {"solid.mps.substep": 1e-6}
    yield dam_break("verification_paper_1mm", words, 0.001, 2)
    for spacing, end in ((0.004, 2), (0.002, 2), (0.001, 2), (0.0005, 0.4)):
        yield dam_break(f"verification_recommended_{1000 * spacing:g}mm", {}, spacing, end)
    for spacing in (0.004, 0.002):
        yield dam_break(f"verification_paper_{1000 * spacing:g}mm", words, spacing, 2)
    yield dam_break("verification_public_code_2mm", words | PUBLIC_CODE, 0.002, 0.6)
    yield dam_break("verification_public_code_1mm", words | PUBLIC_CODE, 0.001, 0.6)


def stiffness(spacing=0.001, end=2):
    """Table 2: 20 MPa to 200 GPa, and rigid, with the recommended settings."""
    for name, modulus in STIFFNESS.items():
        yield dam_break(f"stiffness_recommended_{name}_{1000 * spacing:g}mm", plate(modulus), spacing, end)


def stiffness_paper(spacing=0.001, end=2):
    """Table 2 with the paper's settings."""
    for name, modulus in STIFFNESS.items():
        yield dam_break(f"stiffness_paper_{name}_{1000 * spacing:g}mm", paper_plate(modulus), spacing, end)


LATE_END = 1.25  # s: past the second peak
LID = {"fluid.obstacle": "[{ shape = { min = [0.0, 0.438], max = [0.584, 0.446] } }]"}  # on the tank, at 1.5 H


def starts(family, name, settings, number, spacing, end):
    """The same scene from starts that differ by nothing: ten-thousandths of gravity, sideways."""
    for k in range(number):
        yield dam_break(f"scatter_{family}_{name}_{k}", settings | {"gravity": f"[{k * 1e-3:g}, -9.81]"}, spacing, end)


def scatter():
    """What of a difference between two plates is an accident of the start."""
    for name in ("20MPa", "rigid"):
        yield from starts("recommended", name, plate(STIFFNESS[name]), 6, 0.002, 0.4)
        yield from starts("recommended_1mm", name, plate(STIFFNESS[name]), 5, 0.001, 0.3)
        yield from starts("paper", name, paper_plate(STIFFNESS[name]), 5, 0.002, 0.3)
    # The second peak, when what has gone up the far wall falls back; and what a lid on the tank does to it.
    yield from starts("late", "rigid", plate(None), 5, 0.002, LATE_END)
    yield from starts("lid", "rigid", plate(None) | LID, 3, 0.002, LATE_END)


def finite_width():
    yield Run("finite_width", "dam_break_plate_3d",
              {"fluid.propagation_speed": 1.0, "time.window": 4e-4, "coupling.scheme": "weak"})


SCENES = {"1MPa": {}, "20MPa": plate(2e7)}  # scenes of the chart
CHART_END = 0.4  # s: first blow and answer
VARIANTS = {  # by label: settings in place of the recommended ones
    "deviation, p_min": {"fluid.source": "deviation", "fluid.gradient": "p_min"},
    "mixed": {"fluid.source": "mixed"},
    "window 5e-5 s": {"time.window": 5e-5},
    "window 2e-4 s": {"time.window": 2e-4},
    "window 4e-4 s": {"time.window": 4e-4},
    "mps": {"solid.model": "mps"},
    "hamiltonian": {"solid.model": "hamiltonian"},
    "modal": {"solid.model": "modal"},
    "strong": {"coupling.scheme": "strong", "coupling.iteration.relaxation": "aitken"},
    "weak_inertial": {"coupling.scheme": "weak_inertial", "coupling.velocity": "end"},
    "strong_inertial": {"coupling.scheme": "strong_inertial", "coupling.velocity": "end"},
    "paper": PAPER | {"solid.mps.substep": 1e-6},
}


def chart():
    """What each choice costs and gains, one at a time from the recommended settings at 2 mm; and the spacing."""
    for scene, words in SCENES.items():
        for spacing in (0.004, 0.002, 0.001):
            yield dam_break(f"chart_{scene}_recommended_{1000 * spacing:g}mm", words, spacing, CHART_END)
        for label, variant in VARIANTS.items():
            name = label.replace(", ", "_").replace(" ", "_")
            yield dam_break(f"chart_{scene}_{name}", words | variant, 0.002, CHART_END)


def stiffness_2mm():
    """Table 2 on a coarser lattice, both ways."""
    yield from stiffness(0.002)
    yield from stiffness_paper(0.002)


def reduced():
    """What the tests guard: the verification case and two plates, on 2 mm and to 1 s."""
    yield dam_break("reduced_verification", {}, 0.002, 1)
    for name in ("20MPa", "rigid"):
        yield dam_break(f"reduced_{name}", plate(STIFFNESS[name]), 0.002, 1)


STIFFER = 1.5


def substep_name(modulus, substep):
    return f"open_substep_{modulus:.0e}_{substep:.0e}"


def open_points():
    """What the paper leaves open or misprints."""
    for modulus in list(STIFFNESS.values())[:-1]:
        for substep in (1e-6, 5e-7, 5e-8):
            settings = {"solid.young_modulus": modulus, "solid.density": 7800, "solid.poisson_ratio": 0.3,
                        "solid.model": "mps", "solid.spacing": 0.001, "solid.mps.substep": substep,
                        "time.end": 4000 * substep, "time.window": 400 * substep}
            yield Run(substep_name(modulus, substep), "cantilever", settings)
    # Forces l0 times smaller act like a plate that is stiffer and heavier by as much.
    for name, factor in (("area", 1), ("volume", 1 / 0.004)):
        settings = {"solid.young_modulus": 1e6 * factor, "solid.density": 2500 * factor}
        yield dam_break(f"open_{name}", settings, 0.004, 0.3)
    # The paper's tips are smaller than ours, its loads are not: a plate that is stiffer by one factor?
    yield dam_break("open_stiffer_1MPa", {"solid.young_modulus": STIFFER * 1e6}, 0.002, 0.4)
    yield dam_break("open_stiffer_20MPa", plate(STIFFER * 2e7), 0.002, 0.4)
    # Or the soft water of the public code?
    yield dam_break("open_public_code_20MPa", paper_plate(2e7) | PUBLIC_CODE, 0.002, LATE_END)
    yield dam_break("open_public_code_20MPa_1mm", paper_plate(2e7) | PUBLIC_CODE, 0.001, 0.3)
    # The paper's plates come to rest by a damping that it does not describe; its settings as such have none.
    yield dam_break("open_damped_200MPa", paper_plate(2e8) | {"solid.mps.viscosity": 0.2}, 0.002, 0.9)


GROUPS = {
    "verification": verification, "stiffness_2mm": stiffness_2mm, "scatter": scatter, "chart": chart,
    "open_points": open_points, "finite_width": finite_width, "stiffness": stiffness,
    "stiffness_paper": stiffness_paper, "reduced": reduced,
}


def of(groups):
    """The runs of these groups, each once."""
    return list({run.name: run for group in groups for run in GROUPS[group]()}.values())
