"""The state hash at the end of each scenario, as `resect run NAME` prints it, at any number of threads."""

# State at the end of the scenarios on tissue that stands still: the same on every machine.
STILL = {
    "cut": "b8c3913d2ff0cee5",
    "cut-120": "28aedf1be9f418ac",
    "cut-950": "9f11763aa5e54e3b",
    "deform": "87bda2239206e71b",
    "deform-120": "0f40d3af4a92f21e",
    "deform-950": "85dbe0c97bc162a0",
    "perforate": "ca51a43cd32b47d5",
    "perforate-120": "f1884a5d611aca3e",
    "perforate-950": "b45bea083466915b",
    "resect-segment": "231ec578fc72eec5",
}
# On tissue that moves: the same on every machine, with and without vector instructions.
ELASTIC = {
    "press": "b4a756dc85e5328e",
    "lift": "e56db9127fff35e6",
    "incise": "06fe6fc1896400bc",
    "incise-under-traction": "8a790f6efdf37c04",
    "snip": "77a7c9d1b0b4ca3f",
    "resect-segment-elastic": "abc9ab1150667a0d",
    "liver-and-gallbladder": "1149b6520bd4e222",
    "hang": "f73b9705748bb596",
    "drop": "ec85c536f4e365a0",
}
