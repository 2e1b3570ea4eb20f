# SPDX-License-Identifier: MIT OR Apache-2.0
# `vertices` are (n, 3) positions of the mesh's vertices after a deformation.
import numpy as np
from numpy.typing import NDArray

from . import Mesh

def gaussian_curvature_change(mesh: Mesh, vertices: NDArray[np.float32]) -> float: ...
def self_intersection_ratio(mesh: Mesh, vertices: NDArray[np.float32]) -> float: ...
def normal_error(mesh: Mesh, vertices: NDArray[np.float32]) -> float: ...
