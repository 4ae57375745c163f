# SPDX-License-Identifier: GPL-3.0-or-later
"""The objects that a structure is built from: "of", "query" and "colours" of an entry of "maintain"."""

from families import OF_LINES, OF_QUERY


def in_order(ids, scene):
    """Each once, in the scene's order."""
    return [name for name in scene.ids if name in set(ids)]


def sets_of(tree, scene):
    """[(name, value)] of those that do not have their usual values, in the order and the form of canonical text."""
    result = []
    of = tree.get("of")
    if isinstance(of, list):
        result.append(("of", in_order(of, scene)))
    elif isinstance(of, dict) and "all_but" in of:
        if of["all_but"]:
            result.append(("of", {"all_but": in_order(of["all_but"], scene)}))
    elif isinstance(of, dict):
        result.append(("of", of["colours"][0] if len(of["colours"]) == 1 else of))
    elif of is not None:
        result.append(("of", of))
    if "query" in tree and tree["query"] not in scene.ids[:1]:
        result.append(("query", tree["query"]))
    if "colours" in tree:
        result.append(("colours", tree["colours"]))
    return result


def query_of(options, scene):
    """The number of the query."""
    return scene.number[options["query"]] if "query" in (options or {}) else 0


def with_colours(scene, colours):
    return {i for i, o in enumerate(scene.objects) if o.colour in colours}


def own_objects(name, options, scene):
    """The numbers of the objects that a structure is built from, its query included, by its options in the header of
    a log; None: all of them."""
    options = options or {}
    if "colours" in options:
        return with_colours(scene, options["colours"])
    of = options.get("of")
    if of is None:
        result = None
    elif isinstance(of, str):
        result = with_colours(scene, [of])
    elif isinstance(of, list):
        result = {scene.number[name] for name in of}
    elif "colours" in of:
        result = with_colours(scene, of["colours"])
    else:
        result = set(range(len(scene.ids))) - {scene.number[name] for name in of["all_but"]}
    if name in OF_QUERY and result is not None:
        result.add(query_of(options, scene))
    if name in OF_LINES:
        lines = {i for i, o in enumerate(scene.objects) if o.line}
        result = lines if result is None else result & lines
    return result


def classes_of(options, scene):
    """Two sets of numbers: those of the two colours, or those at even and at odd places."""
    if "colours" in (options or {}):
        return tuple(with_colours(scene, [colour]) for colour in options["colours"])
    everything = range(len(scene.ids))
    return set(everything[0::2]), set(everything[1::2])
