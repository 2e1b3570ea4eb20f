# SPDX-License-Identifier: MIT OR Apache-2.0
"""Ways to search for the least value of a function within bounds. Each takes the function, the start (n,),
the bounds (low, high) and a seed, and goes on until the function raises.
"""

import cma
import numpy as np
import scipy.optimize

#: Adam's step length, and how far the points of a difference lie from the current one, by forward and by
#: central differences: the best of `optimisers.py --tune`.
FORWARD, CENTRAL = (0.2, 0.05), (0.4, 0.1)


def cma_es(function, start, bounds, seed):
    """CMA-ES as in the paper's protocol: σ 1, ⌊12 + 9 ln n⌋ candidates a generation."""
    population_of(function, start, bounds, seed, 1.0, int(12 + 9 * np.log(len(start))))


def small_cma_es(function, start, bounds, seed):
    """CMA-ES as in `standard`: σ 0.5, ⌊4 + 3.5 ln n⌋ candidates a generation."""
    population_of(function, start, bounds, seed, 0.5, int(4 + 3.5 * np.log(len(start))))


def population_of(function, start, bounds, seed, sigma, population):
    """pycma's, from new random numbers when it has stopped by itself."""
    for restart in range(1000):
        options = {"bounds": list(bounds), "popsize": population, "verbose": -9}
        options |= {"seed": 1 + seed + 1000 * restart}
        search = cma.CMAEvolutionStrategy(start, sigma, options)
        while not search.stop():
            candidates = search.ask()
            search.tell(candidates, [function(x) for x in candidates])


def random_search(function, start, bounds, seed):
    """Uniform in the bounds, after the start."""
    random = np.random.default_rng(seed)
    function(start)
    while True:
        function(random.uniform(*bounds, len(start)))


def forward_gradient(function, x, bounds, step):
    """The gradient (n,) by one further point a variable, on the inner side where a bound is near."""
    here = function(x)
    gradient = np.empty(len(x))
    for i in range(len(x)):
        reach = step if x[i] + step <= bounds[1] else -step
        moved = x.copy()
        moved[i] += reach
        gradient[i] = (function(moved) - here) / reach
    return gradient


def central_gradient(function, x, bounds, step):
    """The gradient (n,) by two further points a variable, cut off at the bounds."""
    gradient = np.empty(len(x))
    for i in range(len(x)):
        low, high = x.copy(), x.copy()
        low[i], high[i] = max(x[i] - step, bounds[0]), min(x[i] + step, bounds[1])
        gradient[i] = (function(high) - function(low)) / (high[i] - low[i])
    function(x)
    return gradient


def forward_adam(function, start, bounds, _seed):
    """Adam on forward differences."""
    adam(function, start, bounds, *FORWARD, forward_gradient)


def central_adam(function, start, bounds, _seed):
    """Adam on central differences."""
    adam(function, start, bounds, *CENTRAL, central_gradient)


def adam(function, start, bounds, rate, step, gradient_of):
    """Adam (Kingma and Ba, 2015) on differences, held within the bounds."""
    x = start.copy()
    first, second = np.zeros(len(x)), np.zeros(len(x))
    for count in range(1, 1_000_000):
        gradient = gradient_of(function, x, bounds, step)
        first = 0.9 * first + 0.1 * gradient
        second = 0.999 * second + 0.001 * gradient**2
        direction = first / (1 - 0.9**count) / (np.sqrt(second / (1 - 0.999**count)) + 1e-8)
        x = np.clip(x - rate * direction, *bounds)


def nelder_mead(function, start, bounds, seed):
    """SciPy's, its first simplex as wide as CMA-ES's first step; from its end again when it has stopped."""
    x = start
    while True:
        simplex = np.vstack([x, x + np.where(x + 1 > bounds[1], -1.0, 1.0) * np.eye(len(x))])
        options = {"initial_simplex": simplex, "maxfev": 10**6, "maxiter": 10**6, "adaptive": True}
        x = scipy.optimize.minimize(
            function, x, method="Nelder-Mead", bounds=[bounds] * len(x), options=options
        ).x
