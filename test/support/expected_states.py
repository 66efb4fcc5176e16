"""The state hash at the end of each scenario, as `resect run NAME` prints it, at any number of threads."""

# State at the end of the scenarios on tissue that stands still: the same on every machine.
STILL = {
    "cut": "2da3ef453c960e23",
    "cut-120": "a7f1c54c897e4955",
    "cut-950": "4961ee603ec84896",
    "deform": "eed5d75f82a5a371",
    "deform-120": "a565f7f4b1f29202",
    "deform-950": "f4cfe406d5884a97",
    "perforate": "2e646fa9e191a997",
    "perforate-120": "9dee45dd8fadbd11",
    "perforate-950": "56178b35be71b9d9",
    "resect-segment": "80a8db2ce23b5309",
}
# On tissue that moves: the same on every machine, with and without vector instructions.
ELASTIC = {
    "press": "7e0038ebc69ee594",
    "lift": "a3319f6ac9b7e332",
    "incise": "16fe2e426ee55783",
    "incise-under-traction": "a58953bc854f51b0",
    "snip": "92650b83deb0e2d6",
    "resect-segment-elastic": "abb7f422f2be2cd8",
    "liver-and-gallbladder": "96430a288f200082",
    "hang": "a5021f4dc872f70d",
    "drop": "3e904f6d7168620c",
    "bleed": "f50ed135dfe18e6e",
    "stop-bleeding": "95a22003420c19dc",
    "transect": "d3b69e539f834019",
    "pringle": "3ae4e20f70bf25a1",
    "cautery": "2686db0d91f21286",
    "grasp": "a02d01c357a93116",
}
