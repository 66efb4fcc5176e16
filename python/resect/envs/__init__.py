"""Environments for learning, with Gymnasium's interface; gymnasium itself need not be installed.

    from resect.envs import Incise
    env = Incise()
    state, info = env.reset(seed=1)
    state, reward, terminated, truncated, info = env.step(env.action_space.sample())
"""

from resect.envs.check import Broken, check_env
from resect.envs.incise import Incise
from resect.envs.operation_env import ACTION, OBSERVATIONS, OperationEnv
from resect.envs.reach import Reach
from resect.envs.resect_tumour import ResectTumour
from resect.envs.retract import Retract
from resect.envs.vector import VectorEnv

__all__ = ["ACTION", "Broken", "Incise", "OBSERVATIONS", "OperationEnv", "Reach", "ResectTumour", "Retract", "VectorEnv",
           "check_env"]
