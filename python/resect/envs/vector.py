"""Many environments at once, each in a process or a thread of its own.

Processes write what they observe into memory that they share with this one, so that no array is pickled. A process is
a fork: what it needs must not have been drawing or stepping on several threads before. With context="spawn" it starts
afresh, and the program needs the usual `if __name__ == "__main__":`.
"""

import concurrent.futures
import contextlib
import multiprocessing
import time
import traceback

import numpy as np

import resect
from resect.envs.scene import whole_number
from resect.envs.spaces import Box, Dict


def batched(space, count):
    """The space of `count` values at once."""
    if isinstance(space, Dict):
        return Dict({name: batched(one, count) for name, one in space.spaces.items()})
    return Box(np.broadcast_to(space.low, (count, *space.shape)), np.broadcast_to(space.high, (count, *space.shape)),
               (count, *space.shape), space.dtype)


class _Shared:
    """Arrays of all environments, in memory that processes share."""

    def __init__(self, context, space, action_space, count):
        self.single = not isinstance(space, Dict)
        spaces = {"": space} if self.single else space.spaces
        self._blocks = {name: (context.RawArray("b", max(1, count * int(np.prod(one.shape)) * one.dtype.itemsize)),
                               (count, *one.shape), one.dtype) for name, one in spaces.items()}
        self._actions = (context.RawArray("b", count * int(np.prod(action_space.shape)) * 4),
                         (count, *action_space.shape), np.dtype(np.float32))
        self._numbers = (context.RawArray("b", count * 3 * 8), (count, 3), np.dtype(np.float64))

    @staticmethod
    def _array(block):
        memory, shape, dtype = block
        return np.frombuffer(memory, dtype, int(np.prod(shape))).reshape(shape)

    def open(self):
        """Arrays over the memory, in the process that calls."""
        self.observed = {name: self._array(block) for name, block in self._blocks.items()}
        self.actions, self.numbers = self._array(self._actions), self._array(self._numbers)
        return self

    def __getstate__(self):
        return {"single": self.single, "_blocks": self._blocks, "_actions": self._actions, "_numbers": self._numbers}

    def put(self, number, observation):
        if self.single:
            observation = {"": observation}
        for name, array in self.observed.items():
            array[number] = observation[name]

    def observation(self):
        """A copy of all observations."""
        copies = {name: array.copy() for name, array in self.observed.items()}
        return copies[""] if self.single else copies


def _work(env, number, shared, command, argument):
    """One command in one environment; its numbers: reward, terminated, truncated. Returns its info."""
    if command == "time":
        return time.process_time()
    if command == "reset":
        observation, info = env.reset(seed=argument)
        shared.put(number, observation)
        return info
    observation, reward, terminated, truncated, info = env.step(shared.actions[number])
    if terminated or truncated:
        info = {**info, "final_obs": observation}
        observation, again = env.reset()
        info["reset_info"] = again
    shared.put(number, observation)
    shared.numbers[number] = reward, terminated, truncated
    return info


def _serve(make, number, shared, pipe):
    try:
        shared.open()
        env = make()
        pipe.send(("ready", None))
        while True:
            command, argument = pipe.recv()
            if command == "close":
                break
            try:
                answer = "done", _work(env, number, shared, command, argument)
            except resect.Error as e:
                answer = "refused", str(e)
            pipe.send(answer)
        env.close()
    except (EOFError, KeyboardInterrupt):
        pass
    except BaseException as e:
        pipe.send(("failed", f"{e}" if isinstance(e, resect.Error) else traceback.format_exc()))


class VectorEnv:
    """`count` environments with the interface of Gymnasium's vector environments.

    make: function without arguments that returns an environment. backend: "processes"; "threads", for observations
    without pictures; or "here", one after the other. An environment whose episode is over is reset in the same step:
    its info then has final_obs and reset_info. infos is a list, one per environment. The bits do not depend on backend
    or count: environment i is seeded by seed + i.
    """

    def __init__(self, make, count, backend="processes", context="fork"):
        if backend not in ("processes", "threads", "here"):
            raise resect.Error(f"backend is \"{backend}\"; use processes, threads or here")
        count = whole_number(count, "count", 1, 10_000)
        self.num_envs, self.backend = count, backend
        self._pipes, self._processes, self._envs = [], [], []
        self._pool = None
        if backend == "processes":
            first = make()
            self.single_observation_space = first.observation_space
            self.single_action_space = first.action_space
            first.close()
            del first
        else:
            self._envs = [make() for _ in range(count)]
            self.single_observation_space = self._envs[0].observation_space
            self.single_action_space = self._envs[0].action_space
        self.observation_space = batched(self.single_observation_space, count)
        self.action_space = batched(self.single_action_space, count)
        started = multiprocessing.get_context(context)
        self._shared = _Shared(started, self.single_observation_space, self.single_action_space, count).open()
        if backend == "threads":
            self._pool = concurrent.futures.ThreadPoolExecutor(count)
        for number in range(count if backend == "processes" else 0):
            here, there = started.Pipe()
            process = started.Process(target=_serve, args=(make, number, self._shared, there), daemon=True)
            process.start()
            there.close()
            self._pipes.append(here)
            self._processes.append(process)
        for number in range(len(self._pipes)):
            self._content(number, *self._receive(number))

    def reset(self, *, seed=None, options=None):
        """seed: a number, or a list with one per environment."""
        if seed is None or isinstance(seed, (list, tuple)):
            seeds = seed or [None] * self.num_envs
        else:
            seeds = [whole_number(seed, "seed", 0, 2**62) + i for i in range(self.num_envs)]
        if len(seeds) != self.num_envs:
            raise resect.Error(f"{len(seeds)} seeds were given for {self.num_envs} environments; give one for each")
        infos = self._all("reset", seeds)
        return self._shared.observation(), infos

    def step(self, actions):
        self.send(actions)
        return self.receive()

    def send(self, actions):
        """The first half of step(): what is done between send() and receive() is done while the environments work."""
        try:
            actions = np.asarray(actions, np.float32)
        except (TypeError, ValueError):
            raise resect.Error(f"actions must be an array of numbers {list(self._shared.actions.shape)}") from None
        if actions.shape != self._shared.actions.shape:
            raise resect.Error(f"actions must be an array {list(self._shared.actions.shape)}, not {list(actions.shape)}")
        if not np.isfinite(actions).all():
            number = int(np.argwhere(~np.isfinite(actions))[0, 0])
            raise resect.Error(f"the action of environment {number} is not all numbers; give finite numbers from -1 to 1")
        self._shared.actions[:] = actions
        self._begin("step", [None] * self.num_envs)

    def receive(self):
        """(observations, rewards, terminated, truncated, infos)."""
        infos = self._end()
        reward, terminated, truncated = self._shared.numbers.T
        return self._shared.observation(), reward.copy(), terminated > 0, truncated > 0, infos

    def processor_time(self):
        """s of processor time that the environments have taken so far; of this whole process, if they are in it."""
        return sum(self._all("time", [None] * self.num_envs)) if self._processes else time.process_time()

    def close(self):
        for pipe in self._pipes:
            try:
                pipe.send(("close", None))
            except OSError:
                pass
        for process in self._processes:
            process.join(5)
            if process.is_alive():
                process.terminate()
        self._pipes, self._processes = [], []
        for env in self._envs:
            env.close()
        self._envs = []
        if self._pool:
            self._pool.shutdown()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def _all(self, command, arguments):
        self._begin(command, arguments)
        return self._end()

    def _begin(self, command, arguments):
        if not (self._pipes or self._envs):
            raise resect.Error("these environments were closed; make new ones")
        if self.backend == "processes":
            for pipe, argument in zip(self._pipes, arguments):
                with contextlib.suppress(BrokenPipeError):  # _answer() says whose process has ended
                    pipe.send((command, argument))
            return
        self._due = [(self._envs[i], i, self._shared, command, a) for i, a in enumerate(arguments)]
        if self._pool:
            self._due = [self._pool.submit(_work, *task) for task in self._due]

    def _end(self):
        if self.backend == "processes":
            answers = [self._receive(number) for number in range(self.num_envs)]
            return [self._content(number, *answer) for number, answer in enumerate(answers)]
        if self._pool:
            return [task.result() for task in self._due]
        return [_work(*task) for task in self._due]

    def _receive(self, number):
        try:
            return self._pipes[number].recv()
        except (EOFError, ConnectionResetError):
            return "failed", "its process ended"

    def _content(self, number, word, content):
        if word in ("failed", "refused"):
            raise resect.Error(f"environment {number} of {self.num_envs} failed: {content}")
        return content
