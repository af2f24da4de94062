"""Flags that are no nation's: signals, a race, pride, and a plain sheet."""

from drawing import flag, rectangle
from nations import bars, stripes

BLUE, YELLOW, BLACK, WHITE = "003DA5", "FFD100", "000000", "FFFFFF"  # as bunting is sold: the Code names no shades


def signal_a():  # International Code of Signals (IMO, 2005), letter A: white, blue, swallow-tailed; proportions are free
    picture = bars(960, 800, WHITE, BLUE)
    picture.cut([(960, 0), (720, 400), (960, 800)])
    return picture


def signal_l():  # International Code of Signals (IMO, 2005), letter L: yellow and black quarters
    return flag(960, 800, YELLOW, (BLACK, rectangle(0.6, 0, 1.2, 0.5)), (BLACK, rectangle(0, 0.5, 0.6, 1)))


def checks(width, height, columns, rows, first, second):
    """The first colour in the upper corner at the hoist."""
    across, down = width / height / columns, 1 / rows
    return flag(width, height, first,
                *((second, rectangle(i * across, j * down, (i + 1) * across, (j + 1) * down))
                  for i in range(columns) for j in range(rows) if (i + j) % 2 == 1))


def signal_n():  # International Code of Signals (IMO, 2005), letter N: sixteen checks, blue in the upper hoist
    return checks(960, 800, 4, 4, BLUE, WHITE)


def racing_chequered():  # 4:5, the least size of the FIA's Sporting Code, Appendix H: 80 by 100 cm, checks of 10 cm
    return checks(1000, 800, 10, 8, BLACK, WHITE)


def pride_rainbow():  # 2:3, Gilbert Baker, the six stripes of 1979
    return stripes(1152, 768, "E40303", "FF8C00", "FFED00", "008026", "24408E", "732982")


def pride_transgender():  # 3:5, Monica Helms, 1999
    return stripes(1200, 720, "5BCEFA", "F5A9B8", "FFFFFF", "F5A9B8", "5BCEFA")


def sheet():  # 2:3, unbleached cloth
    return flag(1200, 800, "EFEADF")


DRAWN = (signal_a, signal_l, signal_n, racing_chequered, pride_rainbow, pride_transgender, sheet)
