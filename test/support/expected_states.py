"""The state hash at the end of each scenario, as `resect run NAME` prints it, at any number of threads."""

# State at the end of the scenarios on tissue that stands still: the same on every machine.
STILL = {
    "cut": "76f22ab92932b8be",
    "cut-120": "267d681b86df8c95",
    "cut-950": "797b317f2cef40dd",
    "deform": "8c9b152862fa508d",
    "deform-120": "cfe5f9f6182d7491",
    "deform-950": "cd62772d0b98ffcf",
    "perforate": "9b8c180477738a57",
    "perforate-120": "c700b8d1e0b76929",
    "perforate-950": "da632958bb81b755",
    "resect-segment": "ae837a7ddb2a4ee8",
}
# On tissue that moves: the same on every machine, with and without vector instructions.
ELASTIC = {
    "press": "59e084ca5a503915",
    "lift": "a21832646d6b4625",
    "incise": "4a93d932826805ce",
    "incise-under-traction": "fe7aaa3795e25dbb",
    "snip": "c50e99ba437203bd",
    "resect-segment-elastic": "3758cdc374737095",
    "liver-and-gallbladder": "6b555c6e45ecc781",
    "hang": "c4cdc1ae2a83d34c",
    "drop": "89d87470aa65fa77",
    "bleed": "513d81420d8d6613",
    "stop-bleeding": "fe7538221fa7293a",
}
