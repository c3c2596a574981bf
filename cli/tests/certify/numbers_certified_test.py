#!/usr/bin/env python3
"""A certificate is of the numbers beside a verdict too: a change of one, planted in a plug-in, is not certified, and not verified."""
import json
import unittest

from certificates import CertifyCase
from closest_point import UPWARDS, built


class NumbersCertified(CertifyCase):
    def levels_of(self, kernel, name):
        predicate = json.loads(self.certificate_of(kernel, name=name).read_text())["predicate"]
        return {level["level"]: level["state"] for level in predicate["levels"]}

    def test_a_certificate_is_of_the_numbers_too(self):
        kernel = built(self.folder, "mine")
        good = self.levels_of(kernel, "good")
        bad = self.levels_of(built(self.folder, "changed", "*feature = 6"), "bad")
        self.assertEqual({name for name, state in good.items() if bad.get(name) != state and state == "met"}, {"feature=0.001"}, f"{good}\n{bad}")
        self.verify(self.folder_of("good") / "certificate.json", "--kernel", kernel)
        self.verify(self.folder_of("good") / "certificate.json", "--kernel", built(self.folder, "mine", "*feature = 6"), code=1)

    def test_numbers_have_to_follow_exact_images(self):
        for name, kernel, state in (("exact", "contact", "met"), ("uneven", built(self.folder, "upwards", UPWARDS), "not met")):
            self.assertEqual(self.levels_of(kernel, name)["follows=0.001"], state, name)


if __name__ == "__main__":
    unittest.main()
