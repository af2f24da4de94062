"""National flags, each by the law, decree or standard named beside it; colours that these leave open are the usual ones.

In units of the flag's height, x from the hoist, y down from the top.
"""

import math

from drawing import disc, flag, rectangle, star


def bars(width, height, *colours):
    """Upright bars of equal width, from the hoist."""
    part = width / height / len(colours)
    return flag(width, height, colours[0], *((colour, rectangle(i * part, 0, (i + 1) * part, 1))
                                             for i, colour in enumerate(colours) if i > 0))


def stripes(width, height, *colours):
    """Level stripes of equal height, from the top."""
    part = 1 / len(colours)
    return flag(width, height, colours[0], *((colour, rectangle(0, i * part, width / height, (i + 1) * part))
                                             for i, colour in enumerate(colours) if i > 0))


def cross(width, height, field, *arms):
    """arms: (colour, left, right, top, bottom), an upright arm and a level one that reach the edges."""
    shapes = []
    for colour, left, right, top, bottom in arms:
        shapes += [(colour, rectangle(left, 0, right, 1)), (colour, rectangle(0, top, width / height, bottom))]
    return flag(width, height, field, *shapes)


def nordic(unit, field, fly, hoist, *colours):
    """Widths in units along the fly and down the hoist; colours of the cross from its edge inwards."""
    total = sum(hoist)
    steps = []
    for i, colour in enumerate(colours):
        left, top = sum(fly[:i + 1]), sum(hoist[:i + 1])
        right, bottom = sum(fly) - sum(fly[len(fly) - 1 - i:]), total - sum(hoist[len(hoist) - 1 - i:])
        steps.append((colour, left / total, right / total, top / total, bottom / total))
    return cross(sum(fly) * unit, total * unit, field, *steps)


def strip(start, end, left, right):
    """A strip along the line from start to end, from `left` of it to `right` of it, seen towards its end."""
    (x0, y0), (x1, y1) = start, end
    length = math.hypot(x1 - x0, y1 - y0)
    nx, ny = (y1 - y0) / length, (x0 - x1) / length  # to the left, for y points down
    return [(x0 + nx * left, y0 + ny * left), (x1 + nx * left, y1 + ny * left),
            (x1 - nx * right, y1 - ny * right), (x0 - nx * right, y0 - ny * right)]


def bangladesh():  # 3:5, Flag Rules 1972: the disc's radius 1/5 of the length, its centre at 9/20 of it
    return flag(1200, 720, "006A4E", ("F42A41", disc(0.75, 0.5, 1 / 3)))


def belgium():  # 13:15, Constitution 1831, article 193; Pantone 115 and 032 of the Chancellery's style guide
    return bars(1050, 910, "000000", "FDDA24", "EF3340")


def chile():  # 2:3, Law 2597 of 1912 and Decree 1534 of 1967: a square canton, the star half as wide as its side
    return flag(1200, 800, "FFFFFF", ("D52B1E", rectangle(0, 0.5, 1.5, 1)), ("0039A6", rectangle(0, 0, 0.5, 0.5)),
                ("FFFFFF", star(0.25, 0.25, 0.125)))


def czechia():  # 2:3, Act 3/1993: the wedge reaches the middle of the flag
    return flag(1200, 800, "FFFFFF", ("D7141A", rectangle(0, 0.5, 1.5, 1)),
                ("11457E", [(0, 0), (0.75, 0.5), (0, 1)]))


def denmark():  # 28:37, Royal regulation of 1748: 12:4:21 along the fly, 12:4:12 along the hoist; Pantone 186
    return nordic(32, "C8102E", (12, 4, 21), (12, 4, 12), "FFFFFF")


def estonia():  # 7:11, Estonian Flag Act 2005; Pantone 285
    return stripes(1155, 735, "0072CE", "000000", "FFFFFF")


def finland():  # 11:18, Act 380/1978: 5:3:10 and 4:3:4; the blue of Decision 827/1993, x 0.1856, y 0.1696, Y 5.86
    return nordic(66, "FFFFFF", (5, 3, 10), (4, 3, 4), "134483")


def greece():  # 2:3, Law 851/1978: nine stripes, the canton five of them high and square; it names no shade of blue
    blue = "0D5EAF"
    lines = [(blue, rectangle(0, i / 9, 1.5, (i + 1) / 9)) for i in range(0, 9, 2)]
    return flag(1080, 720, "FFFFFF", *lines, (blue, rectangle(0, 0, 5 / 9, 5 / 9)),
                ("FFFFFF", rectangle(2 / 9, 0, 3 / 9, 5 / 9)), ("FFFFFF", rectangle(0, 2 / 9, 5 / 9, 3 / 9)))


def iceland():  # 18:25, Act 34/1944: 7:1:2:1:14 along the fly, 7:1:2:1:7 along the hoist
    return nordic(48, "02529C", (7, 1, 2, 1, 14), (7, 1, 2, 1, 7), "FFFFFF", "DC1E35")


def ireland():  # 1:2, Constitution 1937, article 7; Pantone 347 and 151 of the Department of the Taoiseach
    return bars(1200, 600, "169B62", "FFFFFF", "FF883E")


def netherlands():  # 2:3, Royal decree 93 of 1937; bright vermilion and cobalt blue of NEN 3055
    return stripes(1080, 720, "AE1C28", "FFFFFF", "21468B")


def nigeria():  # 1:2, National Flag Ordinance 1960
    return bars(1200, 600, "008751", "FFFFFF", "008751")


def norway():  # 8:11, Act of 10 December 1898: 6:1:2:1:12 along the fly, 6:1:2:1:6 along the hoist; Pantone 200, 281
    return nordic(54, "BA0C2F", (6, 1, 2, 1, 12), (6, 1, 2, 1, 6), "FFFFFF", "00205B")


def poland():  # 5:8, Act of 31 January 1980 on the coat of arms, its annex for the colours
    return stripes(1200, 750, "E9E8E7", "D4213D")


def south_africa():
    """2:3, Proclamation of 20 April 1994: the pall a fifth of the height wide, edged by a fifteenth on each side.

    Its arms come from the corners at the hoist and meet in the middle; the edge is gold towards the hoist, else white.
    """
    slope = math.hypot(0.75, 0.5)  # of an arm, from its corner to the middle

    def inside(half):
        """Where the inner edge of an arm meets the other's, from the middle towards the hoist."""
        return half * slope / 0.5

    def pall(half):
        """The Y of this half width, its edges mitred where they meet, its arms past the flag's edges."""
        nx, ny = half * 0.5 / slope, half * 0.75 / slope  # across an arm
        outer = 0.75 + half * (slope - 0.75) / 0.5
        return [(nx - 0.75, -0.5 - ny), (outer, 0.5 - half), (1.6, 0.5 - half), (1.6, 0.5 + half), (outer, 0.5 + half),
                (nx - 0.75, 1.5 + ny), (-nx - 0.75, 1.5 - ny), (0.75 - inside(half), 0.5), (-nx - 0.75, ny - 0.5)]

    def wedge(back):
        """Between the arms, its point this far from the middle."""
        point = 0.75 - back
        return [(0, 0.5 - point / 1.5), (point, 0.5), (0, 0.5 + point / 1.5)]

    return flag(1080, 720, "E03C31", ("001489", rectangle(0, 0.5, 1.5, 1)), ("FFFFFF", pall(1 / 6)),
                ("FFB81C", wedge(0)), ("000000", wedge(inside(1 / 6))), ("007749", pall(1 / 10)))


def thailand():  # 2:3, Flag Act 1979: stripes of 1:1:2:1:1; colours of the announcement of 30 September 2017
    return stripes(1080, 720, "A51931", "F4F5F8", "2D2A4A", "2D2A4A", "F4F5F8", "A51931")


def turkey():
    """2:3, Flag Law 2893 of 1983 and its regulation of 1985, in heights, without the hem at the hoist.

    The crescent's outer circle is 1/2 wide and 1/2 from the hoist, the inner one 4/10 wide and 1/16 further. The star
    lies in a circle 1/4 wide, one point towards the hoist, 1/3 from the inner circle's edge.
    """
    point = 0.5 + 1 / 16 - 0.2 + 1 / 3
    sideways = [(point + 0.125 + y, 0.5 - x) for x, y in star(0, 0, 0.125)]
    return flag(1200, 800, "E30A17", ("FFFFFF", disc(0.5, 0.5, 0.25)), ("E30A17", disc(0.5 + 1 / 16, 0.5, 0.2)),
                ("FFFFFF", sideways))


def ukraine():  # 2:3, Constitution 1996, article 20, and DSTU 4512:2006
    return stripes(1200, 800, "0057B7", "FFD700")


def united_kingdom():
    """1:2, Order in Council of 1 January 1801, its parts in thirtieths of the height as flag makers have them.

    The white saltire is 6 wide, the red one in it 2 wide and beside the diagonal, so that 3 of white lead it on one
    side and 1 follows on the other, alternately: the broad white is above the red at the hoist, below it at the fly.
    The upright cross is 6 wide and edged by 2. Pantone 186 and 280.
    """
    white, red, blue, part = "FFFFFF", "C8102E", "012169", 1 / 30
    middle = (1.0, 0.5)
    past = [(-1, -0.5), (3, -0.5), (-1, 1.5), (3, 1.5)]  # twice as far as the corners
    saltire = [(white, strip(middle, corner, 3 * part, 3 * part)) for corner in past]
    patrick = [(red, strip(middle, corner, 2 * part, 0)) for corner in past]  # to the left, seen from the middle
    return flag(1200, 600, blue, *saltire, *patrick,
                (white, rectangle(1 - 5 * part, 0, 1 + 5 * part, 1)), (white, rectangle(0, 10 * part, 2, 20 * part)),
                (red, rectangle(1 - 3 * part, 0, 1 + 3 * part, 1)), (red, rectangle(0, 12 * part, 2, 18 * part)))


def united_states():
    """10:19, Executive Order 10834 of 1959: the union 7/13 high and 0.76 long, its stars 0.0616 wide.

    Nine rows, a tenth of the union's height apart, of six and five stars a twelfth of its length from column to
    column. Old Glory Red and Old Glory Blue as the State Department has them.
    """
    red, white, blue = "B31942", "FFFFFF", "0A3161"
    high, long = 7 / 13, 0.76
    lines = [(red, rectangle(0, i / 13, 1.9, (i + 1) / 13)) for i in range(0, 13, 2)]
    stars = [(white, star(long * column / 12, high * row / 10, 0.0616 / 2))
             for row in range(1, 10) for column in range(1, 12) if (row + column) % 2 == 0]
    return flag(1235, 650, white, *lines, (blue, rectangle(0, 0, long, high)), *stars)


DRAWN = (bangladesh, belgium, chile, czechia, denmark, estonia, finland, greece, iceland, ireland, netherlands, nigeria,
         norway, poland, south_africa, thailand, turkey, ukraine, united_kingdom, united_states)
