"""The environments: Gymnasium's interface, goals that can be reached, many at once."""
import csv
import os
import re
import signal
import subprocess
import sys
import unittest

import numpy as np
import resect
from resect import envs
from resect.envs import check

ALL = (envs.Reach, envs.Retract, envs.Incise, envs.ResectTumour)


def episode(env, seed, act=None):
    env.reset(seed=seed)
    over = False
    while not over:
        _, _, terminated, truncated, info = env.step(act(env) if act else env.scripted_action())
        over = terminated or truncated
    return info


class Interface(unittest.TestCase):
    def test_every_environment_keeps_the_interface(self):
        for kind in ALL:
            with self.subTest(kind.__name__):
                envs.check_env(kind(max_steps=15), steps=8)
        envs.check_env(envs.Retract("state", actions="position", tissue="liver", particles=300, max_steps=10), steps=5)

    def test_pictures_and_points_are_observations_too(self):
        env = envs.Incise(envs.OBSERVATIONS, particles=500, render_mode="rgb_array", max_steps=8)
        try:
            env.camera().renderer
        except resect.Error as e:
            self.skipTest(str(e))
        envs.check_env(env, steps=4)
        seen, _ = env.reset(seed=1)
        self.assertGreater(len(np.unique(seen["labels"])), 2)
        self.assertEqual(seen["points"][:, 3].min(), 1)

    def test_the_checker_finds_what_is_broken(self):
        class Unseeded(envs.Reach):
            def begin(self):
                self._np_random = np.random.default_rng()
                return super().begin()

        class Live(envs.Reach):
            def _observe(self):
                self.kept = getattr(self, "kept", self.state())
                self.kept[:] = self.state()
                return self.kept

        class WrongSpace(envs.Reach):
            def _observe(self):
                return super()._observe()[:-1]

        class Endless(envs.Reach):
            def step(self, action):
                observation, reward, *_, info = super().step(action)
                self._over, self._steps = False, 0
                return observation, reward, False, "no", info

        for kind, words in ((Unseeded, "same seed"), (Live, "keeps"), (WrongSpace, "not in observation_space"),
                            (Endless, "not bool")):
            with self.subTest(kind.__name__), self.assertRaisesRegex(envs.Broken, words):
                envs.check_env(kind(particles=300, max_steps=10), steps=4)


class Goals(unittest.TestCase):
    def test_a_scripted_operator_reaches_every_goal(self):
        for kind in ALL:
            env = kind()
            for seed in range(2):
                with self.subTest(f"{kind.__name__}, seed {seed}"):
                    self.assertTrue(episode(env, seed)["is_success"])

    def test_an_operator_who_rests_reaches_none(self):
        for kind in ALL:
            env = kind(particles=300, max_steps=12)
            with self.subTest(kind.__name__):
                self.assertFalse(episode(env, 0, lambda e: e.toward(0, e.tips()[0]))["is_success"])

    def test_reset_brings_back_the_uncut_organ(self):
        env = envs.Incise()
        first, _ = env.reset(seed=4)
        state = env.simulation.save()
        episode(env, 7)
        again, _ = env.reset(seed=4)
        self.assertTrue(check.same(first, again))
        self.assertEqual(env.simulation.save(), state)


class Many(unittest.TestCase):
    def bits(self, backend, count=3, steps=12):
        with envs.VectorEnv(lambda: envs.Incise(particles=300, max_steps=8), count, backend) as many:
            many.action_space.seed(5)
            seen = [many.reset(seed=2)[0]]
            for _ in range(steps):  # past the end of the first episodes
                observation, reward, terminated, truncated, infos = many.step(many.action_space.sample())
                seen += [observation, reward, terminated, truncated]
            self.assertEqual(len(infos), count)
        return b"".join(np.ascontiguousarray(a).tobytes() for a in seen)

    def test_the_bits_do_not_depend_on_processes_and_threads(self):
        here = self.bits("here")
        self.assertEqual(here, self.bits("processes"))
        self.assertEqual(here, self.bits("threads"))

    def test_a_refused_action_leaves_the_environments_at_work(self):
        for backend in ("processes", "threads", "here"):
            with self.subTest(backend), envs.VectorEnv(lambda: envs.Reach(particles=300), 2, backend) as many:
                many.reset(seed=0)
                bad = many.action_space.sample()
                bad[1, 0] = np.nan
                with self.assertRaisesRegex(resect.Error, "the action of environment 1 is not all numbers"):
                    many.step(bad)
                self.assertEqual(len(many.step(np.zeros_like(bad))[1]), 2)

    def test_the_first_environment_does_not_depend_on_their_number(self):
        def first(count):
            with envs.VectorEnv(lambda: envs.Reach(particles=300), count, "here") as many:
                observation, _ = many.reset(seed=2)
                actions = np.full((count, 8), 0.5, np.float32)
                return observation[0].tobytes() + b"".join(many.step(actions)[0][0].tobytes() for _ in range(5))
        self.assertEqual(first(1), first(3))

    def test_an_episode_that_is_over_begins_again_in_the_same_step(self):
        with envs.VectorEnv(lambda: envs.Reach(particles=300, max_steps=2), 2) as many:
            many.reset(seed=0)
            still = np.zeros((2, 8), np.float32)
            self.assertFalse(many.step(still)[3].any())
            observation, _, _, truncated, infos = many.step(still)
            self.assertTrue(truncated.all())
            self.assertIn("final_obs", infos[0])
            self.assertFalse(np.array_equal(infos[0]["final_obs"], observation[0]))

    def test_a_process_that_is_killed_is_an_error(self):
        with envs.VectorEnv(lambda: envs.Reach(particles=300), 2) as many:
            many.reset(seed=0)
            os.kill(many._processes[1].pid, signal.SIGKILL)
            with self.assertRaisesRegex(resect.Error, "environment 1 of 2 failed"):
                many.step(np.zeros((2, 8), np.float32))
                many.step(np.zeros((2, 8), np.float32))

    def test_the_bench_writes_a_table(self):
        subprocess.run([sys.executable, "-m", "resect.bench", "--quick", "--envs", "2", "--particles", "300", "--tissue",
                        "plain", "--operator", "scripted", "--csv", "bench.csv"], check=True, capture_output=True, timeout=200)
        with open("bench.csv") as file:
            row, = csv.DictReader(file)
        self.assertEqual((row["env"], row["envs"], row["particles"]), ("Incise", "2", "300"))
        self.assertGreater(float(row["steps_per_s"]), 0)
        self.assertGreater(float(row["share_that_cuts"]), 0.2)

    def test_a_reset_costs_less_than_a_step(self):
        done = subprocess.run([sys.executable, "-m", "resect.bench", "--resets", "--particles", "1000"], check=True,
                              capture_output=True, text=True, timeout=200)
        times = [float(t) for t in re.findall(r"([\d.]+) ms", done.stdout)]
        print(done.stdout, end="")
        self.assertEqual(len(times), 4)
        self.assertLess(max(times), 20)  # 2 on a machine that does nothing else

    def test_a_wrong_setting_is_one_sentence(self):
        with self.assertRaisesRegex(resect.Error, "plain or liver"):
            envs.VectorEnv(lambda: envs.Reach(tissue="wood"), 2)
        for wrong in ({"observation": "smell"}, {"actions": "all"}, {"particles": 3}, {"particles": "many"},
                      {"render_mode": "human"}, {"max_steps": 0}, {"max_steps": 2.5}, {"young": "soft"}):
            with self.subTest(wrong), self.assertRaises(resect.Error):
                envs.Reach(**wrong)

    def test_a_wrong_call_is_one_sentence(self):
        env = envs.Reach(particles=300)
        with self.assertRaisesRegex(resect.Error, "no episode has begun"):
            env.step(np.zeros(8))
        for seed in (-1, "first", 1.5):
            with self.subTest(seed), self.assertRaisesRegex(resect.Error, "seed is"):
                env.reset(seed=seed)
        env.reset(seed=2**60 + 1)
        for action in (["left"] * 8, np.zeros(7), None):
            with self.subTest(action), self.assertRaisesRegex(resect.Error, "8 finite numbers"):
                env.step(action)
        for backend in ("processes", "threads", "here"):
            many = envs.VectorEnv(lambda: envs.Reach(particles=300), 2, backend)
            with self.assertRaisesRegex(resect.Error, "3 seeds were given for 2"):
                many.reset(seed=[1, 2, 3])
            with self.assertRaisesRegex(resect.Error, "array of numbers"):
                many.step([["up"] * 8] * 2)
            many.close()
            with self.assertRaisesRegex(resect.Error, "were closed"):
                many.step(np.zeros((2, 8)))


if __name__ == "__main__":
    unittest.main()
