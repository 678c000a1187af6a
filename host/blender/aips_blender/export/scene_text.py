"""Puts a scene's statements in their order; the world's are kept, film and camera written anew."""
from . import camera, film as film_statements
from .media import CLEAR


class SceneText:
    """What an export has written of its world, to be looked at by any film and view."""

    def __init__(self, text, materials, things, media, spaces):
        self._text = text            # LxsText, empty by now
        self._materials = materials  # lines; they stand before the things that use them
        self._things = things        # lines
        self._media = media
        self._spaces = spaces

    def of(self, film, name, view, matrices):
        """The whole text; `view` is a View, with its matrices while the shutter is open."""
        self._text.comment('Exported from Blender by the add-on of aips.')
        film_statements.write(self._text, film, name)
        if self._spaces.scatter():
            self._text.statement('VolumeIntegrator', 'multi')
        camera.write(self._text, view, matrices)
        head = self._text.taken()
        # At the end it is what the camera stands in; it may be a mixture that is new.
        self._media.sides(CLEAR, self._spaces.at([matrices[0][row][3] for row in range(3)]))
        around = self._text.taken()
        world = self._materials + self._media.statements + self._things + around
        return '\n'.join([*head, 'WorldBegin', *world, 'WorldEnd', ''])
