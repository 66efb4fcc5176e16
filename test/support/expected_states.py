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
    "press": "09365774a8089957",
    "lift": "7ce9902199da46ea",
    "incise": "cde320a2b8379151",
    "incise-under-traction": "1977c4b90fe9d5e0",
    "snip": "064533ff2bd224f0",
    "resect-segment-elastic": "a08e15c2a2bf7582",
    "liver-and-gallbladder": "58a620204485bdf6",
    "hang": "1758851e84e7ca51",
    "drop": "9ca4988b8bc487b8",
}
