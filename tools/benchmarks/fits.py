"""Medians with ranges, fitted exponents, geometric means, and by how much they may be off."""

import dataclasses
import math
import statistics

from student import student_t


@dataclasses.dataclass
class Spread:
    median: float
    low: float
    high: float


def spread(values):
    values = list(values)
    return Spread(statistics.median(values), min(values), max(values))


@dataclasses.dataclass
class Power:
    """y = factor * x^exponent."""
    exponent: float
    error: float  # standard error of the exponent; nan where there are but two points
    factor: float
    degrees: int = 0  # of freedom, of the error

    def __str__(self):
        return f"{self.exponent:.3f} ± {self.error:.3f}"

    def plus_minus(self):
        """Half of the exponent's 95 % interval."""
        return student_t(self.degrees) * self.error


def fit_power(x, y):
    """Least squares of log y over log x."""
    points = [(math.log(a), math.log(b)) for a, b in zip(x, y)]
    n = len(points)
    mean_x, mean_y = (sum(column) / n for column in zip(*points))
    square = sum((a - mean_x) ** 2 for a, _ in points)
    if n < 2 or square == 0:
        raise ValueError("an exponent needs two different x")
    slope = sum((a - mean_x) * (b - mean_y) for a, b in points) / square
    rest = sum((b - mean_y - slope * (a - mean_x)) ** 2 for a, b in points)
    error = math.sqrt(rest / (n - 2) / square) if n > 2 else math.nan
    return Power(slope, error, math.exp(mean_y - slope * mean_x), n - 2)


GROWN_FROM = 10_000  # triangles: their tree no longer fits into the nearest cache


def growth(triangles, costs):
    """The power of the triangles' number with which a cost grows, from GROWN_FROM on; of all points
    where fewer than two are so large."""
    points = list(zip(triangles, costs))
    # Grids have nearly as many triangles as are asked for.
    large = [point for point in points if point[0] >= .9 * GROWN_FROM]
    return fit_power(*zip(*(large if len(large) > 1 else points)))


def times_to_same_error(cpu_ratio, error_ratio, rate):
    """How many times as long it takes to the same error where a picture takes `cpu_ratio` times as
    long and has `error_ratio` times the error, if error falls as time^-rate. With Sobol points rate
    is above 1: the mere product would prefer what takes longer."""
    return cpu_ratio * error_ratio ** (1 / rate)


LEAST_GROWTH = 1.4  # of the time of twice the samples: else it is that of something else


def error_rate(error_ratio, time_ratio):
    """The exponent with which error falls over time, where it is divided by `error_ratio` in
    `time_ratio` times the time; at least 1, that of plain random numbers. nan where that is, and
    where most of the time is not that of samples."""
    if math.isnan(error_ratio) or time_ratio < LEAST_GROWTH:
        return math.nan
    if not error_ratio > 1:
        return 1
    return max(math.log(error_ratio) / math.log(time_ratio), 1)


def geometric_mean(values):
    return math.exp(statistics.mean(map(math.log, values)))


def ratio_of_errors(above, below):
    """nan where one of the two was lost in the reference's noise, which is taken off."""
    return above / below if above > 0 < below else math.nan


def with_factor(ratios):
    """Geometric mean, and the factor by which it may be off: half of its logarithm's 95 % interval,
    by Student's t; nan of a single ratio. Both are nan where a ratio is: the other pairs' alone
    would be those with the larger errors."""
    ratios = list(ratios)
    if not ratios or not all(ratio > 0 for ratio in ratios):
        return math.nan, math.nan
    logs = [math.log(ratio) for ratio in ratios]
    if len(logs) == 1:
        return math.exp(logs[0]), math.nan
    error = statistics.stdev(logs) / math.sqrt(len(logs))
    return math.exp(statistics.fmean(logs)), math.exp(student_t(len(logs) - 1) * error)


def jackknifed(log_of, count):
    """exp of log_of(seeds) by seeds 0 to `count`, and the factor by which it may be off: half of
    the 95 % interval that leaving out each seed in turn tells, nan of a single one. Both are nan
    where the logarithm is without any of them."""
    seeds = range(count)
    if count == 1:
        return math.exp(log_of(seeds)), math.nan
    without = [log_of([seed for seed in seeds if seed != left]) for left in seeds]
    if any(map(math.isnan, without)):
        return math.nan, math.nan
    mean = statistics.fmean(without)
    error = math.sqrt((count - 1) / count * sum((log - mean) ** 2 for log in without))
    return math.exp(log_of(seeds)), math.exp(student_t(count - 1) * error)


def mean_with_factor(means, factors, degrees):
    """Geometric mean of several, and the factor by which it may be off, from theirs, which are of
    so many degrees of freedom each; all together have more [Welch47]."""
    means = list(means)
    squares = [(math.log(factor) / student_t(degrees)) ** 2 for factor in factors]
    error = math.sqrt(sum(squares)) / len(means)
    if not error > 0:
        return geometric_mean(means), math.exp(error)
    together = degrees * sum(squares) ** 2 / sum(square ** 2 for square in squares)
    return geometric_mean(means), math.exp(student_t(together) * error)


def at_level(factor, degrees, level):
    """A factor by which something may be off at another level than 95 %."""
    return factor ** (student_t(degrees, level) / student_t(degrees))


def ratio_columns(key, ratios, factor=None):
    """Of a table: median, range and geometric mean of ratios, one a pair, with half of the 95 %
    interval of the mean's logarithm, that of `factor` where more than the pairs' is known. Empty
    where there are no ratios, or one is nan."""
    names = [f"{key}_{part}" for part in ("ratio", "low", "high", "mean", "plus_minus")]
    ratios = list(ratios)
    if not ratios or any(map(math.isnan, ratios)):
        return dict.fromkeys(names)
    of, (mean, own_factor) = spread(ratios), with_factor(ratios)
    return dict(zip(names, (of.median, of.low, of.high, mean, math.log(factor or own_factor))))


def x_where(y_wanted, x, y):
    """Where a falling curve through the points comes down to y_wanted, straight between points in
    logarithms; None where it starts lower or does not get there: nothing is extrapolated."""
    points = list(zip(x, y))
    for (x0, y0), (x1, y1) in zip(points, points[1:]):
        if y0 >= y_wanted >= y1 > 0 and y0 > y1:
            t = math.log(y0 / y_wanted) / math.log(y0 / y1)
            return x0 * (x1 / x0) ** t
    return None
