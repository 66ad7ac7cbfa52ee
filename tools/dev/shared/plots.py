"""Plots as PNG files, white behind, so that they can be read on any page."""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot  # noqa: E402  (the backend comes first: there is no display)

WIDTH, HEIGHT = 5.2, 3.4  # inches


def line_plot(path, curves, x_label, y_label, log=False, log_x=False, marks="o", spans=()):
    """`curves`: (label, x, y, style) each, or (label, x, y, style, error) with error bars.
    `spans`: (from, to, label) of x to shade."""
    figure, axes = matplotlib.pyplot.subplots(figsize=(WIDTH, HEIGHT), layout="constrained")
    for label, x, y, style, *error in curves:
        axes.errorbar(x, y, yerr=error[0] if error else None, label=label, marker=marks,
                      markersize=4, capsize=2, **style)
    for low, high, label in spans:
        axes.axvspan(low, high, color="0.9", label=label)
    if log:
        axes.set_yscale("log")
    if log or log_x:
        axes.set_xscale("log", base=2)
        axes.set_xticks(curves[0][1], [f"{x:g}" for x in curves[0][1]])
    axes.set(xlabel=x_label, ylabel=y_label)
    axes.grid(alpha=.3)
    axes.legend(fontsize=8, handlelength=3.5)
    save(figure, path)


def power_plot(path, curves, x_label, y_label):
    """`curves` as line_plot's; both axes are logarithmic, to the base of ten. Where they are many
    the legend stands beside the plot, and lines differ where colours begin anew."""
    is_crowded = len(curves) > 6
    figure, axes = matplotlib.pyplot.subplots(
        figsize=(WIDTH * (1.6 if is_crowded else 1), max(HEIGHT, .17 * len(curves))),
        layout="constrained")
    for i, (label, x, y, style, *error) in enumerate(curves):
        dashes = {"linestyle": ("-", "--", ":")[i // 10 % 3]}
        axes.errorbar(x, y, yerr=error[0] if error else None, label=label, marker="o",
                      markersize=4, capsize=2, **dashes | style)
    axes.set(xscale="log", yscale="log", xlabel=x_label, ylabel=y_label)
    axes.grid(alpha=.3)
    if is_crowded:
        axes.legend(fontsize=7, handlelength=3, loc="center left", bbox_to_anchor=(1, .5))
    else:
        axes.legend(fontsize=7, handlelength=3)
    save(figure, path)


def bar_plot(path, groups, y_label):
    """`groups`: name -> {label: value}, each with the same labels, on a logarithmic axis."""
    figure, axes = matplotlib.pyplot.subplots(figsize=(WIDTH, HEIGHT), layout="constrained")
    width = .8 / len(groups)
    for index, (name, values) in enumerate(groups.items()):
        axes.bar([i + (index - (len(groups) - 1) / 2) * width for i in range(len(values))],
                 list(values.values()), width, label=name)
        axes.set_xticks(range(len(values)), list(values))
    axes.set_yscale("log")
    axes.set_ylabel(y_label)
    axes.grid(axis="y", alpha=.3)
    axes.legend(fontsize=8, handlelength=3.5)
    save(figure, path)


def save(figure, path):
    path.parent.mkdir(parents=True, exist_ok=True)
    # Without the version of Matplotlib, so that the same numbers give the same file.
    figure.savefig(path, dpi=120, facecolor="white", metadata={"Software": None})
    matplotlib.pyplot.close(figure)
