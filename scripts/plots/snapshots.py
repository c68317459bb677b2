"""The water by pressure, and the structure."""
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize, to_rgba

from plots.style import plt

HIGHEST = 1.2  # height over width of a snapshot
LONGEST = 5  # width over height of a scene that is shown as a whole
WALL_KINDS = (1, 2)  # kinds of fluid particles: wall, dummy; 0 is water
SOLID_COLOR, WALL_COLOR = "#e8743b", "#b8bcc2"
AZIMUTH, ELEVATION = -1.0, 0.42  # rad: of the eye, as in the pages of cosurge report


def seen(run, particles):
    """Positions in the picture, how near they are, and which are numbers. The last coordinate points up."""
    position = particles["position"]
    shown = np.isfinite(position).all(axis=1)
    if is_flat(run):
        return position, np.zeros(len(position)), shown
    x, y, z = position.T
    ca, sa, ce, se = np.cos(AZIMUTH), np.sin(AZIMUTH), np.cos(ELEVATION), np.sin(ELEVATION)
    points = np.stack([-sa * x + ca * y, -ca * se * x - sa * se * y + ce * z], axis=1)
    return points, ca * ce * x + sa * ce * y + se * z, shown


def dots(axes, points, spacing, overlap=1.3, **style):
    """Particles as discs slightly larger than their spacing."""
    scale = axes.transData.transform([(0, 0), (1, 0)])
    points_per_metre = (scale[1, 0] - scale[0, 0]) * 72 / axes.figure.dpi
    area = (overlap * spacing * points_per_metre) ** 2
    return axes.scatter(points[:, 0], points[:, 1], s=area, linewidths=0, **style)


def view_of(run, spacing):
    """Limits of the picture, without a few drops and the walls above the water; of a long scene the part around the
    structure."""
    low, high, bodies = [], [], []
    for frame in run.frames:
        for group in ("fluid", "solid"):
            if "position" not in frame.get(group, {}):
                continue
            points, _, shown = seen(run, frame[group])
            wall = np.isin(frame[group].get("kind", np.zeros(len(points))), WALL_KINDS)
            if not is_flat(run):
                shown = shown & ~wall
            low.append(np.percentile(points[shown], 0.05, axis=0))
            high.append(np.percentile(points[shown], 99.95, axis=0))
            high[-1][1] = np.percentile(points[shown & ~wall, 1], 99.5)
            if group == "solid":
                bodies += [low[-1][0], high[-1][0]]
    low, high = np.min(low, axis=0), np.max(high, axis=0)
    margin = max(0.03 * max(high - low), *(side for side in spacing.values() if side))
    low, high = low - margin, high + margin
    most = LONGEST * (high - low)[1]
    if bodies and (high - low)[0] > most:
        middle = np.clip(np.mean([min(bodies), max(bodies)]), low[0] + most / 2, high[0] - most / 2)
        low[0], high[0] = middle - most / 2, middle + most / 2
    narrow = max(0, (high - low)[1] / HIGHEST - (high - low)[0]) / 2
    return low - (narrow, 0), high + (narrow, 0)


def is_flat(run):
    return run.case.get("dimension", 2) == 2


def values_of(run, fluid):
    """What the water is coloured by: pressure [kPa]; in three dimensions, where one sees the surface, speed [m/s]."""
    return fluid["pressure"] / 1000 if is_flat(run) else np.linalg.norm(fluid["velocity"], axis=1)


def water_scale(run):
    """The value that 1 % of the water exceeds."""
    wet = np.concatenate([values_of(run, frame["fluid"])[frame["fluid"]["kind"] == 0] for frame in run.frames])
    wet = wet[np.isfinite(wet) & (wet > 0)]
    return float(np.percentile(wet, 99)) if len(wet) else 1.0


def water_colors(run, fluid, top):
    """Colours of the fluid's particles: the water by its values, walls grey."""
    colors = plt.get_cmap("viridis")(np.clip(np.nan_to_num(values_of(run, fluid)) / top, 0, 1))
    colors[np.isin(fluid["kind"], WALL_KINDS)] = to_rgba(WALL_COLOR)
    return colors


def draw_frame(run, axes, frame, spacing, top):
    """All particles in one go, the nearest last, and darker the farther they are; walls in two dimensions only.
    Returns the scale of the values, None without water."""
    flat = is_flat(run)
    points, near, colors, spacings = [], [], [], []
    for group in ("fluid", "solid"):
        if "position" not in frame.get(group, {}):
            continue
        places, depth, shown = seen(run, frame[group])
        if group == "fluid":
            kinds = (0, *WALL_KINDS) if flat else (0,)
            shown = shown & np.isin(frame[group]["kind"], kinds)
        color = water_colors(run, frame[group], top) if group == "fluid" else np.tile(to_rgba(SOLID_COLOR), (len(places), 1))
        points.append(places[shown])
        near.append(depth[shown])
        colors.append(color[shown])
        spacings.append(np.full(shown.sum(), spacing[group]))
    points, near, colors, spacings = (np.concatenate(parts) for parts in (points, near, colors, spacings))
    if not flat:
        order = np.argsort(near, kind="stable")
        points, near, colors, spacings = points[order], near[order], colors[order], spacings[order]
        light = 0.6 + 0.4 * (near - near.min()) / max(np.ptp(near), 1e-12)
        colors[:, :3] *= light[:, None]
    dots(axes, points, spacings, overlap=1.4 if flat else 1.7, color=colors)
    axes.set_title(f"t = {frame['time']:.3f} s")
    return ScalarMappable(Normalize(0, top), "viridis") if "fluid" in frame else None


def snapshots(run):
    if not run.frames:
        return None
    fluid, solid = run.case.get("fluid", {}), run.case.get("solid", {})
    spacing = {"fluid": fluid.get("spacing"), "solid": solid.get("spacing", fluid.get("spacing"))}
    low, high = view_of(run, spacing)
    columns = min(3, len(run.frames))
    rows = -(-len(run.frames) // columns)
    width = 3.6
    height = width * (high - low)[1] / (high - low)[0]
    figure, grid = plt.subplots(rows, columns, squeeze=False, sharex=True, sharey=True, layout="constrained",
                                figsize=(columns * (width + 0.3) + 1, rows * (height + 0.4) + 0.4))
    for axes in grid.flat:
        axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal")
        axes.grid(False)
        axes.tick_params(length=2, labelsize=8)
    figure.suptitle(run.title)
    figure.canvas.draw()  # settles the scale that the size of the discs needs
    top = water_scale(run) if "fluid" in run.frames[0] else None
    for axes, frame in zip(grid.flat, run.frames):
        scale = draw_frame(run, axes, frame, spacing, top)
    for axes in grid.flat[len(run.frames):]:
        axes.set_visible(False)
    if scale is not None:
        figure.colorbar(scale, ax=grid, label="pressure [kPa]" if is_flat(run) else "speed [m/s]", shrink=0.8, aspect=30, extend="max")
    for axes in grid.flat:
        if not is_flat(run):  # a projection has no scales
            axes.set(xticks=[], yticks=[])
    if is_flat(run):
        for axes in grid[-1]:
            axes.set_xlabel("x [m]")
    return figure
