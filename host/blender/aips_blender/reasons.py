"""Says in one line why something could not be done, whatever was raised."""
import traceback


class Told(Exception):
    """An error whose text is for the user, as it is."""


def reason(error):
    """The line; of what nobody foresaw it names the kind and the place, and the console has all."""
    if isinstance(error, (Told, OSError)):
        return str(error)
    traceback.print_exception(type(error), error, error.__traceback__)
    places = traceback.extract_tb(error.__traceback__)
    where = f' ({places[-1].name}, line {places[-1].lineno})' if places else ''
    return f'{type(error).__name__}: {error}{where}; the console has more'
