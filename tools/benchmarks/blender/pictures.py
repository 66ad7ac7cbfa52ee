"""The comparison with Cycles to look at: pictures, their differences, and the threshold's plot."""

import matplotlib
import numpy
import plots  # chooses the backend
from pixels import block_means, encoded

WIDTH, HEIGHT = 8.4, 1.6  # inches; height of each scene
BLOCK = 4  # pixels


def agreement(path, rows):
    """`rows`: (scene, ours, theirs, Agreement), pictures being means over the seeds."""
    figure, axes = matplotlib.pyplot.subplots(
        len(rows), 4, figsize=(WIDTH, HEIGHT * len(rows)), layout="constrained", squeeze=False)
    for (_, ours, theirs, result), line in zip(rows, axes):
        line[0].imshow(encoded(ours))
        line[1].imshow(encoded(theirs))
        # A hundredth of the mean keeps black pixels from dividing by nothing.
        relative = (ours - theirs).mean(axis=2) / (theirs.mean(axis=2) + .01 * theirs.mean())
        difference = line[2].imshow(100 * relative, cmap="RdBu", vmin=-5, vmax=5)
        worst = numpy.take_along_axis(
            result.t, numpy.abs(result.t).argmax(axis=2)[..., None], axis=2)[..., 0]
        t = line[3].imshow(worst, cmap="RdBu", vmin=-6, vmax=6)
        for image, panel in ((difference, line[2]), (t, line[3])):
            figure.colorbar(image, ax=panel, shrink=.8)
    save(figure, axes, path, rows, ("candela", "Cycles", "difference, %", "t by block"))


def references(path, rows):
    """`rows`: (scene, ours, theirs). As bright as ours shows nine tenths of its pixels."""
    figure, axes = matplotlib.pyplot.subplots(
        len(rows), 3, figsize=(WIDTH * 3 / 4, 2 * len(rows)), layout="constrained", squeeze=False)
    for (_, ours, theirs), line in zip(rows, axes):
        exposure = .9 / max(numpy.quantile(ours, .9), 1e-30)
        line[0].imshow(encoded(exposure * ours))
        line[1].imshow(encoded(exposure * theirs))
        a, b = (block_means(image, BLOCK).mean(axis=2) for image in (ours, theirs))
        difference = line[2].imshow(100 * (a - b) / (b + .01 * b.mean()), cmap="RdBu_r", vmin=-20,
                                    vmax=20)
        figure.colorbar(difference, ax=line[2], shrink=.8)
    save(figure, axes, path, rows, ("candela", "Cycles", "difference, %"))


def save(figure, axes, path, rows, titles):
    """Pictures by scene, under titles."""
    for panel in axes.flat:
        panel.set(xticks=[], yticks=[])
    for panel, (scene, *_) in zip(axes[:, 0], rows):
        panel.set_ylabel(scene, fontsize=8)
    for panel, title in zip(axes[0], titles):
        panel.set_title(title, fontsize=9)
    plots.save(figure, path)


def threshold(path, rows):
    """True error against the threshold, a line a scene."""
    scenes = list(dict.fromkeys(row.scene for row in rows))
    figure, axes = matplotlib.pyplot.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
    for scene in scenes:
        mine = [row for row in rows if row.scene == scene]
        x, y = [row.threshold for row in mine], [100 * row.rmse for row in mine]
        bars = [[y_ - 100 * row.rmse_low for y_, row in zip(y, mine)],
                [100 * row.rmse_high - y_ for y_, row in zip(y, mine)]]
        axes[0].errorbar(x, y, yerr=bars, marker="o", markersize=4, capsize=2, label=scene)
        axes[1].plot(x, [100 * row.beyond for row in mine], "o-", markersize=4, label=scene)
    axes[0].set(xscale="log", yscale="log", ylabel="true rMSE, %")
    axes[0].set_yticks([1, 2, 5, 10], ["1", "2", "5", "10"])
    axes[1].set(xscale="log", ylabel="pixels whose true error is above it, %", ylim=(0, None))
    ticks = sorted({row.threshold for row in rows})
    for panel in axes:
        panel.set_xticks(ticks, [f"{x:g}" for x in ticks])
        panel.minorticks_off()
        panel.set_xlabel("Cycles' noise threshold")
        panel.grid(alpha=.3)
    axes[0].legend(fontsize=7)
    plots.save(figure, path)
