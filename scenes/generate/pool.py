"""Fifty small lamps on the walls around a pool."""

from mesh import numbers

LAMPS = 50
HALF_LENGTH, HALF_WIDTH, HEIGHT = 6.75, 4.6, 2.1  # the rectangle they stand on
RADIUS = 0.07


def positions():
    """Evenly spaced along the rectangle, starting at a corner."""
    sides = ((2 * HALF_LENGTH, (-HALF_LENGTH, -HALF_WIDTH), (1, 0)),
             (2 * HALF_WIDTH, (HALF_LENGTH, -HALF_WIDTH), (0, 1)),
             (2 * HALF_LENGTH, (HALF_LENGTH, HALF_WIDTH), (-1, 0)),
             (2 * HALF_WIDTH, (-HALF_LENGTH, HALF_WIDTH), (0, -1)))
    perimeter = sum(length for length, _, _ in sides)
    for k in range(LAMPS):
        along = perimeter * (k + 0.5) / LAMPS
        for length, (x, y), (dx, dy) in sides:
            if along < length:
                yield (x + dx * along, y + dy * along, HEIGHT)
                break
            along -= length


def lamps():
    """Emission and matter of the lamps are the including scene's."""
    lines = []
    for point in positions():
        lines += ["AttributeBegin", f"  Translate {numbers(point)}",
                  f'  Shape "sphere" "float radius" [{RADIUS}]', "AttributeEnd"]
    return "\n".join(lines) + "\n"


def files():
    return {"pool-lamps.lxs": lamps()}
