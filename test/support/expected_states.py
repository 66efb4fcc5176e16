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
    "press": "ea50f575eb06325e",
    "lift": "951b121631aa11ab",
    "incise": "f2d5ee4080732d5f",
    "incise-under-traction": "a87578ab697fc08e",
    "snip": "c3d502c9e58aac46",
    "resect-segment-elastic": "47345b3aa5d25134",
    "liver-and-gallbladder": "760de08826c8ffdd",
    "hang": "955f0b3b4fefc4d0",
    "drop": "1f2f47fe41b2d44d",
    "bleed": "81cc1f08db4e7afd",
    "stop-bleeding": "4b542337cbd4920d",
    "transect": "a7c4f00838201b37",
    "bare-clip-divide": "859d388a766f8d55",
    "pringle": "e21ec9d803c15b2c",
    "cautery": "4dbd31f1d12e6240",
    "grasp": "e3ac1d6fa43e4246",
}
