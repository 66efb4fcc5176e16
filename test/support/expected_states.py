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
    "press": "0a4bbb82f50a761f",
    "lift": "d388baa29d5119a4",
    "incise": "c9e710318de4eb8a",
    "incise-under-traction": "4d8513aec63c4c3e",
    "snip": "1d4fcbd17981804d",
    "resect-segment-elastic": "9fe4d0a37a8c0db8",
    "liver-and-gallbladder": "74d7507f5bb69e07",
    "hang": "58bd4eaf6b4c0c63",
    "drop": "58d50f8c5a9a2326",
}
