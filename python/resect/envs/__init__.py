"""Environments for learning, with Gymnasium's interface; gymnasium itself need not be installed.

    from resect.envs import Incise
    env = Incise()
    state, info = env.reset(seed=1)
    state, reward, terminated, truncated, info = env.step(env.action_space.sample())
"""

from resect.envs.operation_env import ACTION, OBSERVATIONS, OperationEnv
from resect.envs.reach import Reach

__all__ = ["ACTION", "OBSERVATIONS", "OperationEnv", "Reach"]
