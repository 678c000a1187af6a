"""Walks a graph of shader nodes: which node feeds a socket, through reroutes, groups and mutes."""
import dataclasses


@dataclasses.dataclass(frozen=True)
class Place:
    """An input socket, with the group nodes within which it lies, the innermost last."""
    socket: object
    groups: tuple = ()


@dataclasses.dataclass(frozen=True)
class Source:
    """A node that feeds a place, by which of its outputs."""
    node: object
    output: object
    groups: tuple = ()

    def input(self, *names):
        """The place of the first enabled input of one of these names."""
        for name in names:
            for socket in self.node.inputs:
                if name in (socket.name, socket.identifier) and socket.enabled:
                    return Place(socket, self.groups)
        return None


def link_to(socket):
    """The link that feeds a socket, or None; Cycles passes over the same ones."""
    for link in socket.links:
        if link.is_valid and not link.is_muted and link.from_socket.enabled \
                and link.to_socket.enabled:
            return link
    return None


def source(place):
    """What feeds a place, or None where nothing does."""
    socket, groups = place.socket, place.groups
    while link := link_to(socket):
        node, output = link.from_node, link.from_socket
        if node.type == 'REROUTE':
            socket = node.inputs[0]
        elif node.mute:
            passed = [i.from_socket for i in node.internal_links if i.to_socket == output]
            if not passed:
                return None
            socket = passed[0]
        elif node.type == 'GROUP' and node.node_tree:
            inner = _group_output(node.node_tree)
            if inner is None:
                return None
            socket, groups = _named(inner.inputs, output.identifier), groups + (node,)
        elif node.type == 'GROUP_INPUT' and groups:
            socket, groups = _named(groups[-1].inputs, output.identifier), groups[:-1]
        else:
            return Source(node, output, groups)
    return None


def before(found):
    """What feeds the inputs of a node."""
    sources = [source(Place(socket, found.groups)) for socket in found.node.inputs
               if socket.enabled]
    return [each for each in sources if each]


def first_before(found, kinds):
    """The nearest of these kinds of nodes: a node itself, or one that feeds it; or None."""
    near, seen = [found], set()
    while near:
        at = near.pop(0)
        if at.node.type in kinds:
            return at
        if at.node.as_pointer() not in seen:
            seen.add(at.node.as_pointer())
            near += before(at)
    return None


def darkest(found):
    """Of the colours that a node or those before it are set to, the darkest; grey if there are
    none."""
    colors, near, seen = [], [found], set()
    while near:
        at = near.pop()
        if at.node.as_pointer() in seen:
            continue
        seen.add(at.node.as_pointer())
        ramp = getattr(at.node, 'color_ramp', None)
        colors += [tuple(e.color[:3]) for e in ramp.elements] if ramp else []
        colors += [tuple(s.default_value[:3]) for s in at.node.inputs
                   if s.type == 'RGBA' and s.enabled and link_to(s) is None]
        near += before(at)
    return min(colors, key=sum, default=(0.5, 0.5, 0.5))


def constant(place):
    """The value that a place has where nothing feeds it: of the outermost group's socket."""
    socket, groups = place.socket, place.groups
    while link := link_to(socket):
        node, output = link.from_node, link.from_socket
        if node.type == 'REROUTE':
            socket = node.inputs[0]
        elif node.type == 'GROUP_INPUT' and groups:
            socket, groups = _named(groups[-1].inputs, output.identifier), groups[:-1]
        else:
            break
    value = socket.default_value
    return float(value) if isinstance(value, (int, float)) else tuple(value)


def output_node(tree, kind):
    """The active output node (OUTPUT_MATERIAL, OUTPUT_WORLD, OUTPUT_LIGHT) for Cycles or all."""
    nodes = [n for n in tree.nodes if n.type == kind]
    suited = [n for n in nodes if n.target in ('ALL', 'CYCLES')] or nodes
    active = [n for n in suited if n.is_active_output]
    return (active or suited or [None])[0]


def _group_output(tree):
    nodes = [n for n in tree.nodes if n.type == 'GROUP_OUTPUT']
    active = [n for n in nodes if n.is_active_output]
    return (active or nodes or [None])[0]


def _named(sockets, identifier):
    return next(s for s in sockets if s.identifier == identifier)
