"""The state hash at the end of each scenario, as `resect run NAME` prints it, at any number of threads."""

# State at the end of the scenarios on tissue that stands still: the same on every machine.
STILL = {
    "cut": "fc950961750336b5",
    "cut-120": "02d227cbc774ff3f",
    "cut-950": "2927fff034681bf4",
    "deform": "679159f0ce78c14b",
    "deform-120": "6ef81ea82f339892",
    "deform-950": "f43f8a00d1917755",
    "perforate": "226fed6659f95bea",
    "perforate-120": "bb034123529bb0ee",
    "perforate-950": "bfc0aa80277e2b98",
    "resect-segment": "25234120411d7f61",
}
# On tissue that moves: the same on every machine, with and without vector instructions.
ELASTIC = {
    "press": "2752144d3a2fb13b",
    "lift": "59044c412bcc44ba",
    "incise": "68e9d7c4e469a8e7",
    "incise-under-traction": "69715ed52985b4dc",
    "snip": "471cf86294aa0731",
    "resect-segment-elastic": "d4f4442d58e89447",
    "liver-and-gallbladder": "d46a3087f92f71cf",
    "hang": "bed42cd98adc8665",
    "drop": "03be77817fe3add2",
    "bleed": "318bc9c505d446a8",
    "stop-bleeding": "8b62f911390be3fa",
    "transect": "9b449535a261423d",
    "bare-clip-divide": "29bf362d837a3454",
    "pringle": "2cbf23af1f99b0c8",
    "cautery": "ddb66d1ff68af361",
    "grasp": "d1d583e037712889",
}
