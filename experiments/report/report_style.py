"""How figures look: Okabe and Ito's palette, safe for colour-blind readers, and labels that keep out of each other's way."""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.transforms import Bbox

# These three take the page's own colours, light or dark; nothing else in a figure has exactly these values.
INK, GRID, PAPER = "#1a1b1c", "#d9dadb", "#fffffe"
ORANGE, SKY, GREEN, YELLOW, BLUE, VERMILION, PURPLE, GREY = ("#E69F00", "#56B4E9", "#009E73", "#F0E442", "#0072B2", "#D55E00", "#CC79A7",
                                                             "#8a8a8a")

KERNELS = {"float": ORANGE, "double": VERMILION, "double-eps=1e-12": PURPLE, "double-eps=rel:1e-12": "#8C4F76", "epick": SKY, "epeck": BLUE,
           "rational": GREY, "adaptive": GREEN}
MARKERS = {"tree": "o", "tuned": "v", "paper": "^", "brute": "s", "peer": "D", "program": "P"}
WIDTH = 7.2  # inches: two columns of a journal; type of 7 points stays 7 points there


def set_style():
    plt.rcParams.update({
        "svg.hashsalt": "tetracone", "font.size": 7.5, "axes.titlesize": 8, "axes.spines.top": False, "axes.spines.right": False,
        "text.color": INK, "axes.labelcolor": INK, "axes.edgecolor": INK, "xtick.color": INK, "ytick.color": INK, "grid.color": GRID,
        "grid.linewidth": 0.5, "axes.linewidth": 0.6, "figure.facecolor": "none", "axes.facecolor": "none", "savefig.facecolor": "none",
        "axes.axisbelow": True, "pdf.fonttype": 42})


def colour_of(kernel):
    """A peer is drawn in ink."""
    return KERNELS.get(kernel, INK)


def mark(kernel, method, exact):
    """How a way of answering is drawn: colour the kernel, shape the method, filled when exact by construction."""
    colour = colour_of(kernel)
    return dict(marker=MARKERS[method], color=colour, mec=colour, mfc=colour if exact else PAPER, mew=1.1, ls="", ms=5)


PLACES = ((1, 0, "left", "center"), (-1, 0, "right", "center"), (0, 1, "center", "bottom"), (0, -1, "center", "top"),
          (.7, .7, "left", "bottom"),
          (-.7, .7, "right", "bottom"), (.7, -.7, "left", "top"), (-.7, -.7, "right", "top"), (.3, 1, "left", "bottom"),
          (-.3, 1, "right", "bottom"),
          (.3, -1, "left", "top"), (-.3, -1, "right", "top"))


def bring_up_to_date(axis):
    """The axis's transform, as drawing its whole figure would."""
    axis.get_xlim()
    axis.get_ylim()


def box_of(figure, around=0.03):
    """The box, in inches, of what is drawn, with so much around it: measured once for all files of a figure."""
    return figure.get_tightbbox(figure.canvas.get_renderer()).padded(around)


def label_points(axis, labels, obstacles):
    """Puts (x, y, text, colour) beside its point, where it covers neither another label nor one of the points `obstacles`.
    Call when the layout is final."""
    figure = axis.figure
    bring_up_to_date(axis)
    renderer, pixel = figure.canvas.get_renderer(), figure.dpi / 72
    taken = [Bbox.from_bounds(x - 3.5 * pixel, y - 3.5 * pixel, 7 * pixel, 7 * pixel)
             for x, y in (axis.transData.transform(p) for p in obstacles)]
    frame = axis.get_window_extent(renderer)
    for x, y, text, colour in labels:
        best = None
        for distance in (5, 9, 14, 20, 27, 35, 44, 54, 65, 77, 90):
            for dx, dy, ha, va in PLACES:
                note = axis.annotate(text, (x, y), xytext=(dx * distance, dy * distance), textcoords="offset points", ha=ha, va=va,
                                     color=colour,
                                     fontsize=6.5, zorder=6,
                                     arrowprops=dict(arrowstyle="-", lw=0.5, color=colour, shrinkA=0, shrinkB=2) if distance > 9 else None)
                note.update_positions(renderer)
                box = matplotlib.text.Text.get_window_extent(note, renderer)  # without the arrow
                outside = box.x0 < frame.x0 or box.x1 > frame.x1 + 4 * pixel or box.y0 < frame.y0 or box.y1 > frame.y1 + 2 * pixel
                cost = sum(box.overlaps(other) for other in taken) + 10 * outside
                note.remove()
                if best is None or cost < best[0]:
                    best = cost, dict(xytext=(dx * distance, dy * distance), ha=ha, va=va, far=distance > 9), box
                if cost == 0:
                    break
            if best[0] == 0:
                break
        _, place, box = best
        far = place.pop("far")
        axis.annotate(text, (x, y), textcoords="offset points", color=colour, fontsize=6.5, zorder=6,
                      arrowprops=dict(arrowstyle="-", lw=0.5, color=colour, shrinkA=0, shrinkB=2) if far else None, **place)
        taken.append(box)


def label_ends(axis, ends, gap=8.5):
    """Names the curves that end at (x, y) at the panel's right, one below the other, `gap` points apart at least.
    Call when the layout is final."""
    figure = axis.figure
    bring_up_to_date(axis)
    pixel = figure.dpi / 72
    frame = axis.get_window_extent(figure.canvas.get_renderer())
    placed = sorted(((axis.transData.transform((x, y)), text, colour) for x, y, text, colour in ends), key=lambda e: e[0][1])
    heights = [min(max(p[1], frame.y0), frame.y1) for p, _, _ in placed]
    for _ in range(200):  # pushes neighbours apart until all stand
        moved = False
        for k in range(len(heights) - 1):
            lack = gap * pixel - (heights[k + 1] - heights[k])
            if lack > 1e-6:
                heights[k] -= lack / 2
                heights[k + 1] += lack / 2
                moved = True
        if heights and heights[0] < frame.y0:
            heights = [h + frame.y0 - heights[0] for h in heights]
        if not moved:
            break
    for (point, text, colour), height in zip(placed, heights):
        x, y = axis.transAxes.inverted().transform((frame.x1 + 10 * pixel, height))
        axis.annotate(text, axis.transAxes.inverted().transform(point), xycoords="axes fraction", xytext=(x, y), textcoords="axes fraction",
                      va="center",
                      fontsize=6.5, color=colour, annotation_clip=False,
                      arrowprops=dict(arrowstyle="-", lw=0.5, color=colour, alpha=0.6, shrinkA=0, shrinkB=0))


def key_of_marks(fig, kernels, methods, y=0.0):
    """The key: kernels (name, exact) by colour, then methods by shape."""
    handles = [plt.Line2D([], [], label=k, **mark(k, "tree", exact)) for k, exact in kernels]
    handles += [plt.Line2D([], [], ls="", marker=MARKERS[m], ms=4.5, color=GREY, label=m) for m in methods]
    half = (len(handles) + 1) // 2 if len(handles) > 9 else len(handles)
    fig.legend(handles=handles, ncol=half, fontsize=6.5, frameon=False, loc="lower center", bbox_to_anchor=(0.5, y), handletextpad=0.1,
               columnspacing=1.0)
