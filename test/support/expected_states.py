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
    "incise": "3a51059da9293aed",
    "incise-under-traction": "914a31ffc4f39f6b",
    "snip": "a8e88ce34d77b6be",
    "resect-segment-elastic": "d7937cb3ccdbc2e3",
    "liver-and-gallbladder": "e79571041d1e548c",
    "hang": "9ca00c039e6e29e7",
    "drop": "2fc2542281657f87",
    "bleed": "97c1ea8e2de782a9",
    "stop-bleeding": "2eb65cdc44de7f64",
    "transect": "0bf18ab261405453",
    "bare-clip-divide": "c9b7ae7df9900179",
    "pringle": "cb6a90d198526d1f",
    "cautery": "bbd19afbfeefd6f3",
    "grasp": "dfcecded0e9e2259",
}
