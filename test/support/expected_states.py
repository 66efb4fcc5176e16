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
    "lift": "78ba493d894e6f39",
    "incise": "4cac739346fac85c",
    "incise-under-traction": "cdb76c51ddc35508",
    "snip": "b46658080ea04a6b",
    "resect-segment-elastic": "f24b6f29b7184325",
    "liver-and-gallbladder": "96430a288f200082",
    "hang": "a5021f4dc872f70d",
    "drop": "3e904f6d7168620c",
    "bleed": "ed07d0c4c71f2e1a",
    "stop-bleeding": "7f4be20ff046be8d",
    "transect": "4c2fdd0cdd657e6b",
    "pringle": "2368e212ba44dd8b",
    "cautery": "c8781b99cd6c5660",
    "grasp": "1a86d1eb70d0bef3",
}
