"""Tables that programs write into the manual."""
import re


def replace_table(manual, name, script, header, rows):
    """Writes a table into the manual, between the comments that mark its place."""
    begin, end = f'<!-- table of {name}: written by {script} -->\n', '<!-- end of table -->'
    before, rest = manual.read_text().split(begin)
    lines = [[re.sub('E_([av])', r'<i>E</i><sub>\1</sub>', cell) for cell in header], ['---'] * len(header)] + rows
    table = ''.join('| ' + ' | '.join(line) + ' |\n' for line in lines)
    manual.write_text(before + begin + '\n' + table + '\n' + rest[rest.index(end):])
