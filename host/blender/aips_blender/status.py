"""What the status line tells of a render: by its latest image, its log and the clock."""
from .process import PROGRESS


def clock(seconds):
    whole = int(seconds + 0.5)
    hours, minutes = whole // 3600, whole // 60 % 60
    return f'{hours}:{minutes:02}:{whole % 60:02}' if hours else f'{minutes}:{whole % 60:02}'


def error_of(texts):
    """Estimated relative error in an image's header, or None before the third pass."""
    relmse = float(texts.get('relMSE', 'nan'))
    return relmse ** 0.5 if relmse >= 0 else None


def newer(texts, line):
    """An image's header, or in its place what a line of progress tells if that is of more passes.

    Images come seldom where writing one takes long, lines every ten seconds.
    """
    found = PROGRESS.match(line)
    if found is None or int(found[1]) <= int(texts.get('passes', 0)):
        return texts
    told = {'passes': found[1]}
    if found[2]:
        told['relMSE'] = str((float(found[2]) / 100) ** 2)
    return {**texts, **told}


def share(film, texts, seconds):
    """How much of the work is done, 0 to 1, by the bound that is nearest."""
    shares = [0.0]
    if film.passes:
        shares.append(int(texts.get('passes', 0)) / film.passes)
    if film.seconds:
        shares.append(seconds / film.seconds)
    error = error_of(texts)
    if film.error and error:
        # Errors fall by the root of the work.
        shares.append((film.error / error) ** 2)
    return min(max(shares), 1.0)


def text(film, texts, seconds):
    """One line: passes, error, target, time."""
    if not texts:
        return f'aips: the first pass is being rendered, {clock(seconds)} gone'
    passes = texts.get('passes', '0') + (f' of {film.passes}' if film.passes else '')
    parts = [f'aips: pass {passes}']
    error = error_of(texts)
    if error is not None:
        target = f', {100 * film.error:.3g} % wanted' if film.error else ''
        parts.append(f'error {100 * error:.2g} %{target}')
    parts.append(f'{clock(seconds)} gone')
    return ', '.join(parts)


def done(texts):
    """What is told of a render that has ended."""
    error = error_of(texts)
    return 'aips: done' + (f', error {100 * error:.2g} %' if error is not None else '')
