"""CSV files that outlive the runs they tell of: the command, then rows; empty where a number is not known."""
import csv


def read(path, texts):
    """Rows, floats but for the columns `texts`; none where there is no file."""
    if not path.exists():
        return []
    with open(path, newline="") as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        return [{key: value if key in texts else float(value or "nan") for key, value in row.items()} for row in rows]


def write(path, command, rows, texts, digits):
    columns = list(dict.fromkeys(key for row in rows for key in row))
    with open(path, "w", newline="") as file:
        file.write(f"# {command}\n")
        writer = csv.DictWriter(file, columns, lineterminator="\n")
        writer.writeheader()
        for row in rows:
            short = {key: value if key in texts else f"{value:.{digits}g}" for key, value in row.items()}
            writer.writerow({key: text for key, text in short.items() if text != "nan"})


def rounded(row, digits):
    """Numbers as they will be read again."""
    return {key: float(f"{value:.{digits}g}") for key, value in row.items()}
