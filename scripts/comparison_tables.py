"""Reads the tables that the program compare leaves in its output folder."""

import csv
import pathlib
import re
import sys

# how the methods are called in figures
LABELS = {
    'anisotropic_fitting': 'This package, default',
    'anisotropic_fitting_paper': 'Wang, Yu 2012',
    'isotropic_fitting': 'Wang, Yu 2012, isotropic',
    'bilateral': 'Fleishman et al. 2003',
    'noniterative': 'Jones et al. 2003',
    'mean_normals': 'Yagou et al. 2002, mean',
    'median_normals': 'Yagou et al. 2002, median',
    'alpha_trimmed_normals': 'Yagou et al. 2003',
    'adaptive_gaussian_normals': 'Ohtake et al. 2002',
    'thresholded_normals': 'Sun et al. 2007',
    'prescribed_mean_curvature': 'Hildebrandt, Polthier 2004',
    'bilateral_normals': 'Zheng et al. 2011',
    'guided_normals': 'Zhang et al. 2015',
    'laplacian': 'Laplacian',
    'taubin': 'Taubin 1995',
}


def label(method):
    return LABELS.get(method, method.replace('_', ' ').replace('smooth shape', 'smooth_shape(),'))


def read_table(folder, name):
    """The rows of a CSV table, as dictionaries; those of failed runs are left out."""
    path = pathlib.Path(folder) / name
    try:
        with open(path, newline='') as file:
            return [row for row in csv.DictReader(file) if not row.get('failure')]
    except OSError as error:
        sys.exit(f'{path}: {error.strerror}')


def unique(values):
    return list(dict.fromkeys(values))


def pair_title(pair):
    words = re.sub(r'([a-z])([0-9.]+)$', r'\1 \2', pair)  # noise and its level
    return words.replace('_irregular_', ', ').replace('_', ' ')


def check_methods(known, wanted):
    for method in wanted:
        if method not in known:
            sys.exit(f"there is no result of the method '{method}'")
