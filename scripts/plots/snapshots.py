"""The water by pressure, and the structure."""
import numpy as np

from plots.style import plt

HIGHEST = 1.2  # height over width of a snapshot
WALL_KINDS = (1, 2)  # kinds of fluid particles: wall, dummy; 0 is water
SOLID_COLOR, WALL_COLOR = "#e8743b", "#b8bcc2"


def axes_of(run):
    """Horizontal and upward axis of the pictures, and the axis across them, in three dimensions."""
    gravity = np.array(run.case.get("gravity", [0, -1]))
    dimension = run.case.get("dimension", 2)
    if dimension == 2:
        return 0, 1, None
    up = int(np.abs(gravity).argmax())
    across = 1 if up == 2 else 2
    return ({0, 1, 2} - {up, across}).pop(), up, across


def slice_of(run, particles, spacing):
    """Positions in the picture's plane: all of them, or the middle slice of three dimensions."""
    right, up, across = axes_of(run)
    position = particles["position"]
    shown = np.isfinite(position).all(axis=1)
    if across is not None and shown.any():
        middle = np.nanmean([np.nanmin(position[:, across]), np.nanmax(position[:, across])])
        shown &= np.abs(position[:, across] - middle) <= 0.75 * spacing
    return position[:, [right, up]], shown


def dots(axes, points, spacing, overlap=1.3, **style):
    """Particles as discs slightly larger than their spacing."""
    scale = axes.transData.transform([(0, 0), (1, 0)])
    points_per_metre = (scale[1, 0] - scale[0, 0]) * 72 / axes.figure.dpi
    area = (overlap * spacing * points_per_metre) ** 2
    return axes.scatter(points[:, 0], points[:, 1], s=area, linewidths=0, **style)


def view_of(run, spacing):
    """Limits of the picture, without a few drops and the walls above the water."""
    low, high = [], []
    for frame in run.frames:
        for group in ("fluid", "solid"):
            if "position" not in frame.get(group, {}):
                continue
            points, shown = slice_of(run, frame[group], spacing[group])
            wall = np.isin(frame[group].get("kind", np.zeros(len(points))), WALL_KINDS)
            low.append(np.percentile(points[shown], 0.05, axis=0))
            high.append(np.percentile(points[shown], 99.95, axis=0))
            high[-1][1] = np.percentile(points[shown & ~wall, 1], 99.5)
    low, high = np.min(low, axis=0), np.max(high, axis=0)
    margin = max(0.03 * max(high - low), *(side for side in spacing.values() if side))
    low, high = low - margin, high + margin
    narrow = max(0, (high - low)[1] / HIGHEST - (high - low)[0]) / 2
    return low - (narrow, 0), high + (narrow, 0)


def pressure_scale(run):
    wet = [frame["fluid"]["pressure"][frame["fluid"]["kind"] == 0] for frame in run.frames]
    wet = np.concatenate(wet)
    wet = wet[np.isfinite(wet) & (wet > 0)]
    return float(np.percentile(wet, 99)) if len(wet) else 1.0


def draw_frame(run, axes, frame, spacing, top):
    image = None
    if "fluid" in frame:
        fluid = frame["fluid"]
        points, shown = slice_of(run, fluid, spacing["fluid"])
        wall, water = shown & np.isin(fluid["kind"], WALL_KINDS), shown & (fluid["kind"] == 0)
        dots(axes, points[wall], spacing["fluid"], overlap=1.6, color=WALL_COLOR)
        image = dots(axes, points[water], spacing["fluid"], c=fluid["pressure"][water] / 1000, cmap="viridis",
                     vmin=0, vmax=top / 1000)
    if "solid" in frame and "position" in frame["solid"]:
        points, shown = slice_of(run, frame["solid"], spacing["solid"])
        dots(axes, points[shown], spacing["solid"], overlap=1.4, color=SOLID_COLOR)
    axes.set_title(f"t = {frame['time']:.3f} s")
    return image


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
    top = pressure_scale(run) if "fluid" in run.frames[0] else None
    for axes, frame in zip(grid.flat, run.frames):
        image = draw_frame(run, axes, frame, spacing, top)
    for axes in grid.flat[len(run.frames):]:
        axes.set_visible(False)
    if image is not None:
        figure.colorbar(image, ax=grid, label="pressure [kPa]", shrink=0.8, aspect=30, extend="max")
    for axes in grid[-1]:
        axes.set_xlabel("x [m]")
    return figure
