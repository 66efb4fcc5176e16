"""Spaces of actions and observations: those of gymnasium where it is installed, else Box and Dict of the same form."""

import numpy as np

try:
    from gymnasium.spaces import Box, Dict, Space
except ImportError:

    class Space:
        """What Box and Dict have in common."""

        def __init__(self, shape=None, dtype=None, seed=None):
            self.shape = None if shape is None else tuple(shape)
            self.dtype = None if dtype is None else np.dtype(dtype)
            self.seed(seed)

        def seed(self, seed=None):
            self.np_random = np.random.Generator(np.random.PCG64(seed))
            return seed

        def __contains__(self, x):
            return self.contains(x)

    class Box(Space):
        """Arrays of one shape and type between two bounds, which are included."""

        def __init__(self, low, high, shape=None, dtype=np.float32, seed=None):
            if shape is None:
                shape = np.broadcast(np.asarray(low), np.asarray(high)).shape
            self.low = np.full(shape, low, dtype) if np.isscalar(low) else np.asarray(low, dtype).reshape(shape)
            self.high = np.full(shape, high, dtype) if np.isscalar(high) else np.asarray(high, dtype).reshape(shape)
            super().__init__(shape, dtype, seed)

        def sample(self):
            if np.issubdtype(self.dtype, np.integer):
                return self.np_random.integers(self.low, self.high, endpoint=True, dtype=self.dtype)
            finite = np.isfinite(self.low) & np.isfinite(self.high)
            between = self.np_random.uniform(np.where(finite, self.low, 0), np.where(finite, self.high, 1))
            return np.where(finite, between, self.np_random.normal(size=self.shape)).astype(self.dtype)

        def contains(self, x):
            return (isinstance(x, np.ndarray) and x.shape == self.shape and np.can_cast(x.dtype, self.dtype) and
                    bool(np.all(x >= self.low) and np.all(x <= self.high)))

        def __eq__(self, other):
            return (isinstance(other, Box) and self.shape == other.shape and self.dtype == other.dtype and
                    np.array_equal(self.low, other.low) and np.array_equal(self.high, other.high))

        def __repr__(self):
            return f"Box({self.low.min()}, {self.high.max()}, {self.shape}, {self.dtype})"

    class Dict(Space):
        """A dictionary of spaces."""

        def __init__(self, spaces, seed=None):
            self.spaces = dict(spaces)
            super().__init__(seed=seed)

        def seed(self, seed=None):
            super().seed(seed)
            for number, space in enumerate(getattr(self, "spaces", {}).values()):
                space.seed(None if seed is None else seed + number)
            return seed

        def sample(self):
            return {name: space.sample() for name, space in self.spaces.items()}

        def contains(self, x):
            return isinstance(x, dict) and x.keys() == self.spaces.keys() and all(
                space.contains(x[name]) for name, space in self.spaces.items())

        def __getitem__(self, name):
            return self.spaces[name]

        def __eq__(self, other):
            return isinstance(other, Dict) and self.spaces == other.spaces

        def __repr__(self):
            return f"Dict({self.spaces})"

try:
    from gymnasium import Env
except ImportError:

    class Env:
        """The attributes and methods that gymnasium.Env has."""

        metadata = {"render_modes": []}
        render_mode = None
        spec = None
        _np_random = None

        @property
        def unwrapped(self):
            return self

        @property
        def np_random(self):
            if self._np_random is None:
                self._np_random = np.random.Generator(np.random.PCG64())
            return self._np_random

        def reset(self, *, seed=None, options=None):
            if seed is not None:
                self._np_random = np.random.Generator(np.random.PCG64(seed))

        def step(self, action):
            raise NotImplementedError

        def close(self):
            pass

        def __enter__(self):
            return self

        def __exit__(self, *_):
            self.close()

__all__ = ["Box", "Dict", "Env", "Space"]
