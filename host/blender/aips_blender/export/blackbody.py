"""The colour of a black body, as Cycles has it: of luminance 1, in linear Rec. 709."""
import numpy as np

COLDEST, HOTTEST = 800.0, 12000.0  # kelvin; Cycles keeps to these
SECOND_RADIATION = 1.438777e7      # c2 of Planck's law, nm K
WAVELENGTHS = np.arange(380.0, 781.0, 10.0)  # nm
# CIE 1931, x y z in 1e-6, as analytic fits are up to 10 % off where red alone is left.
MATCHING = 1e-6 * np.array([
    1368, 39, 6450, 4243, 120, 20050, 14310, 396, 67850, 43510, 1210, 207400,
    134380, 4000, 645600, 283900, 11600, 1385600, 348280, 23000, 1747060, 336200, 38000, 1772110,
    290800, 60000, 1669200, 195360, 90980, 1287640, 95640, 139020, 812950, 32010, 208020, 465180,
    4900, 323000, 272000, 9300, 503000, 158200, 63270, 710000, 78250, 165500, 862000, 42160,
    290400, 954000, 20300, 433450, 994950, 8750, 594500, 995000, 3900, 762100, 952000, 2100,
    916300, 870000, 1650, 1026300, 757000, 1100, 1062200, 631000, 800, 1002600, 503000, 340,
    854450, 381000, 190, 642400, 265000, 50, 447900, 175000, 20, 283500, 107000, 0,
    164900, 61000, 0, 87400, 32000, 0, 46770, 17000, 0, 22700, 8210, 0,
    11359, 4102, 0, 5790, 2091, 0, 2899, 1047, 0, 1440, 520, 0,
    690, 249, 0, 332, 120, 0, 166, 60, 0, 83, 30, 0, 42, 15, 0]).reshape(-1, 3)
FROM_XYZ = np.array([[3.2404542, -1.5371385, -0.4985314], [-0.9692660, 1.8760108, 0.0415560],
                     [0.0556434, -0.2040259, 1.0572252]])


def blackbody(kelvin):
    """Three numbers; what Rec. 709 cannot mix is cut off at 0, as Cycles does."""
    kelvin = min(max(kelvin, COLDEST), HOTTEST)
    radiance = WAVELENGTHS ** -5 / np.expm1(SECOND_RADIATION / (WAVELENGTHS * kelvin))
    xyz = radiance @ MATCHING
    return tuple(float(max(c, 0.0)) for c in FROM_XYZ @ (xyz / xyz[1]))
