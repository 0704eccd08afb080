# SPDX-License-Identifier: GPL-3.0-or-later
"""What a ball feels of an organ along a path, solved by finite elements: the truth of models.

    truth = solve_truth(organ, Press())

needs the extra `reference`; without it `solve_truth` says what to install. Stages: `subject` makes
a body of the organ, `paths` and `walks` the stations of the path, `graded` a mesh that is fine
there, `elasticity` and `cholesky` its stiffness and factor, `patches` what of it the ball may
touch, `contact` the ball, `hold` one that has taken hold; `levels` does so for one mesh, `solve`
for finer and finer ones.
"""

from palpate_editor.truth.find_truth import solve_truth as solve_truth
from palpate_editor.truth.progress import Progress as Progress
from palpate_editor.truth.progress import Stopped as Stopped
from palpate_editor.truth.progress import TruthError as TruthError
from palpate_editor.truth.wanted import Drag as Drag
from palpate_editor.truth.wanted import Press as Press
from palpate_editor.truth.wanted import Pull as Pull
from palpate_editor.truth.wanted import Script as Script
