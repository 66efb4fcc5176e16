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
    "press": "3f9ab92c511ddb85",
    "lift": "82b9eee147f5b960",
    "incise": "525e57730f9020a1",
    "incise-under-traction": "6308851084f3de8c",
    "snip": "8c100320d6927cff",
    "resect-segment-elastic": "9ac2ea8247d0faa9",
    "liver-and-gallbladder": "e461b2085c0157f5",
    "hang": "15b0662567d20dad",
    "drop": "2722569b760e8778",
}
