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
    "press": "731920988613a1d6",
    "lift": "11975a681c50fbc5",
    "incise": "ca6b83e2bd5befd8",
    "incise-under-traction": "04aff875db0cb7b6",
    "snip": "9baefe5a43ab4c9d",
    "resect-segment-elastic": "c730be9b6a014ab3",
    "liver-and-gallbladder": "dd08debfd1461efb",
    "hang": "45e8073d2a41303e",
    "drop": "411678fc870058d4",
    "bleed": "cb04f8af321d305b",
    "stop-bleeding": "25c95072d95809ab",
    "transect": "e6432cbd6f904a72",
    "bare-clip-divide": "cde087083121600d",
    "pringle": "80328f31f33c84a6",
    "cautery": "ebd06e6c37ebc10e",
    "grasp": "91d9ef780405640a",
}
