"""Why each task is practised: for the page about it. Facts have their source."""
WHY_TOUCH = (
    "In a flat picture depth is judged from shadows, from what covers what, and from the size of the "
    "instrument; a target that is missed is mostly missed in depth. Touching gently is part of the goal: "
    "9 of 16 figures of force told 11 experts from 21 novices (Horeman et al. 2012, 10.1109/TOH.2011.60).")
WHY_TWO_HANDS = (
    "Tissue under tension opens before the blade, which then needs less force. One hand makes the "
    "tension, the other cuts; beginners let the first one go while they look at the second. How the hands "
    "work together is measured by the correlation of their speeds (after Hofstad et al. 2013, "
    "10.1007/s00464-012-2524-9).")
WHY_CONTROL = (
    "Blood hides its own source. Suction or pressure first, then a clip on the vessel, then heat for what "
    "is left: so the wound can be seen at each step. Surgeons grade a bleeding by its rate, from 0 up to "
    "1 ml a minute to 4 above 50 (VIBe, Lewis et al. 2017, 10.1186/s12893-020-00874-w); they may differ "
    "by one grade.")
WHY_CLIP = (
    "A vessel that is cut before it is closed bleeds from both ends, and the ends draw back into the "
    "liver, where they are hard to find. Two clips with room between them leave a stump on either side "
    "that holds.")
WHY_WEDGE = (
    "The margin is the figure of a specimen that the surgeon decides. With 10 mm or more, 34 % of "
    "patients were free of disease after five years, with less 21 % (PMC3521554). Today 1 mm counts as "
    "free of tumour (R0).")
WHY_LATERAL = (
    "Inside the liver nothing marks the plane: it is kept by looking at both of its ends. In a randomised "
    "trial of two techniques with the inflow occluded surgeons parted 1.0 and 1.1 cm2 a minute and lost "
    "452 and 515 ml in all (PMC3521554).")
