"""The state hash at the end of each scenario, as `resect run NAME` prints it, at any number of threads."""

# State at the end of the scenarios on tissue that stands still: the same on every machine.
STILL = {
    "cut": "80fe54df0fbcb760",
    "cut-120": "45b57c14b7012d0b",
    "cut-950": "05eabb6d2993dc9e",
    "deform": "318201cbe00a9670",
    "deform-120": "bbcd2debcfa283ad",
    "deform-950": "2f503612b51e583e",
    "perforate": "c9e1fad56ed3bdec",
    "perforate-120": "f15b4d792d90c812",
    "perforate-950": "00531f86d9f6efff",
    "resect-segment": "39125f893070951b",
}
# On tissue that moves: the same on every machine, with and without vector instructions.
ELASTIC = {
    "press": "cf31839ef7419e30",
    "lift": "8471bddadb2add04",
    "incise": "0a73ff3230a73496",
    "incise-under-traction": "b9a13320f26ea44d",
    "snip": "9036af7cdf00b08b",
    "resect-segment-elastic": "95b2ed8e8cf7a5aa",
    "liver-and-gallbladder": "e79571041d1e548c",
    "hang": "db4ab713dbc5a9b0",
    "drop": "2fc2542281657f87",
    "bleed": "ef143d3d733f7ddd",
    "stop-bleeding": "dc889a3d936fa4e1",
    "transect": "8695d518ea3d01dc",
    "bare-clip-divide": "79ada23f57ce1f6e",
    "pringle": "bace7fdedf8da13f",
    "cautery": "bbd19afbfeefd6f3",
    "grasp": "dfcecded0e9e2259",
}
